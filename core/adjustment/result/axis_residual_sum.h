#pragma once

#include <cstddef>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

/// The joint residuals of the arcs at one axis angle, which share centre and radius; like `ArcFit` for one
/// arc.
struct AxisResidualSum {
  std::size_t sightings = 0;
  int degreesOfFreedom = 0;
  double chiSquare = 0;
  double residualRms = 0;  ///< arcseconds

  double reducedChiSquare() const { return degreesOfFreedom > 0 ? chiSquare / degreesOfFreedom : 0; }
};

AxisResidualSum residualSumAt(const SessionFit& fit, int axisDeg);

}  // namespace alidade
