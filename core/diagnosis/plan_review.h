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

// What a plan of readings can and cannot see, before anything is read: the places, faces, rounds and slider
// readings of a session count, not what was read there.

/// How an effect of its plausible size would show; of one that is known, as large as what is known leaves
/// open.
struct PlannedEffect {
  std::string effect;
  /// Length of its trace, σ of the readings, in the direction of its numbers that shows least and most; the
  /// same where it has one number.
  double leastVisible = 0, mostVisible = 0;
  /// What could not be told from it where it shows most.
  std::vector<LookAlike> lookAlikes;
  /// On Δd, mm, ≥ 0, in the direction that moves it most, and what it leaves there, σ: as a diagnosis has it.
  double influence = 0, visibleThere = 0;
  bool undetectable = false;
};

/// Readings to add, and what they would be good for.
struct PlanAdvice {
  std::vector<Measure> measures;
  std::vector<std::string> reveals;  ///< undetectable so far, the most dangerous first
  std::vector<std::pair<std::string, std::string>>
      separates;  ///< look-alikes so far, told apart whichever it is
};

struct PlanReview {
  std::vector<PlannedEffect> effects;                ///< in the order of the catalogue
  std::vector<PlanAdvice> advice;                    ///< the most useful first
  std::optional<IntersectionEstimate> intersection;  ///< Δd of the plan with the noise as stated
  std::size_t readings = 0;                          ///< circle and slider readings
  /// U of the measurement as planned, then with what would bring it down the most; empty without Δd.
  std::vector<AttainableUncertainty> attainable = {};
};

/// Fails where no arc can be fitted to places like these. `fit` is that of the measurement.
Result<PlanReview, NoModel> reviewPlan(const Measurement& measurement, const SessionFit& fit);
Result<PlanReview, NoModel> reviewPlan(const Measurement& measurement);

}  // namespace alidade
