#pragma once

#include <cstddef>

#include "core/adjustment/result/session_fit.h"

namespace alidade::ui {

/// What the arcs of one axis, which share centre and radius, leave over together; as `ArcFit` has it of one.
struct AxisMisfit {
  std::size_t sightings = 0;
  int degreesOfFreedom = 0;
  double chiSquare = 0;
  double residualRms = 0;  ///< arcseconds

  double reducedChiSquare() const { return degreesOfFreedom > 0 ? chiSquare / degreesOfFreedom : 0; }
};

AxisMisfit misfitAt(const SessionFit& fit, int axisDeg);

}  // namespace alidade::ui
