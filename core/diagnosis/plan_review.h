#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/diagnosis_fault.h"
#include "core/diagnosis/visibility.h"
#include "core/session/measurement.h"

namespace alidade {

// Reviews what a plan of readings shows, before anything is read. Only the visits, faces, rounds and slider
// readings of the session count, not their values.

/// The visibility of an effect of plausible size, or of the uncertainty of its known size.
struct PlannedEffect {
  std::string effect;
  /// Length of the trace, σ of the readings, in the least and the most visible direction of the parameters.
  /// Both lengths are equal for a single parameter.
  double leastVisible = 0, mostVisible = 0;
  /// Its look-alikes in the most visible direction.
  std::vector<LookAlike> lookAlikes;
  /// Influence on Δd, mm, ≥ 0, and length of the trace, σ. Both refer to the direction of the parameters that
  /// changes Δd most, as in a diagnosis.
  double influence = 0, visibleThere = 0;
  bool undetectable = false;
};

/// Readings to add, and their benefit.
struct PlanAdvice {
  std::vector<Measure> measures;
  std::vector<std::string> reveals;  ///< formerly undetectable effects, the largest influence first
  std::vector<std::pair<std::string, std::string>>
      separates;  ///< former look-alikes, separated whichever is the cause
};

struct PlanReview {
  std::vector<PlannedEffect> effects;                ///< in the order of the catalogue
  std::vector<PlanAdvice> advice;                    ///< the largest benefit first
  std::optional<IntersectionEstimate> intersection;  ///< Δd of the plan with the stated noise
  std::size_t readings = 0;                          ///< circle and slider readings
  /// U of the planned measurement, then U with the measures that reduce it most. Empty without Δd.
  std::vector<AttainableUncertainty> attainable = {};
};

/// Fails if no arc can be fitted to the planned visits. `fit` is the fit of the measurement.
Result<PlanReview, NoModel> reviewPlan(const Measurement& measurement, const SessionFit& fit);
Result<PlanReview, NoModel> reviewPlan(const Measurement& measurement);

}  // namespace alidade
