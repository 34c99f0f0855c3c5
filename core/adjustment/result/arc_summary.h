#pragma once

#include <vector>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

/// One arc, or all arcs at one axis angle, which share centre and radius.
struct ArcSummary {
  std::vector<const ArcFit*> arcs;  ///< at least one
  ArcSigma sigma;
  int sightings = 0;
  double degreesOfFreedom = 0;  ///< as `ArcResidualSum::degreesOfFreedom`, of all its arcs
  double chiSquare = 0;
  double residualRms = 0;  ///< arcseconds

  const Circle& circle() const { return arcs.front()->circle; }
  /// NaN without redundancy.
  double reducedChiSquare() const;
};

/// Returns the summary of one arc, which must outlive it.
ArcSummary summaryOf(const ArcFit& arc, const ArcSigma& sigma);

/// Returns the summaries of the fit's axis angles, 0° before 180°. `fit` must outlive them.
std::vector<ArcSummary> summariesByAxis(const SessionFit& fit);

}  // namespace alidade
