#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/simulation/sealed_truth.h"

namespace alidade {

// The score of a diagnosis, with the seal open. The right answer depends on what the readings could show:
//
//   none the verdict is within-noise
//   faint an effect that leaves less than `clearVisibility` σ: not reported, or named
//   unique a visible effect without look-alikes: it is the first cause
//   look-alikes a visible effect with look-alikes: it is the first cause or in the group of the first,
//                     and that group contains at most one that is not a look-alike
//   gross_error exactly the readings that are wrong, and nothing else
//   two_causes both, whatever else
//   unknown the verdict is not-in-catalogue; an effect of the user's own counts as unknown if the session
//           does not state it
//   others the relation of the vertical circle, a jump, larger noise: it is the first cause
//
// A truth file without the visibility of the effect is scored as `others`.

enum class TrialClass { None, Faint, Unique, LookAlikes, GrossError, SeveralCauses, Unknown, Other };

/// "none", "faint", "unique", …
std::string_view nameOf(TrialClass trialClass);

/// An effect that leaves less than this many σ in the readings may be missed.
inline constexpr double clearVisibility = 6;

struct TrialScore {
  TrialClass trialClass = TrialClass::None;
  bool right = false;
  std::string answer = {};  ///< the only cause, "several-causes" if more are named, else the verdict
  bool detected = false;    ///< a gap was found at all
  bool named = false;       ///< the truth, alone or in a group, is the first cause
  /// Is the true Δd within Δd ± U with the causes found? Absent without a named cause or without Δd.
  std::optional<bool> covered = {};
  /// Is the true Δd within Δd ± U with the causes found, and measured, for any answer? Absent without Δd.
  std::optional<bool> coveredAfter = {}, coveredMeasured = {};
  /// Is reduced χ² with the causes found at noise level (p above 0.1 %), if a cause is named?
  std::optional<bool> backToNoise = {};
};

TrialClass classOf(const SealedTruth& truth);

TrialScore scoreTrial(const SealedTruth& truth, const Diagnosis& diagnosis);

/// Checks a diagnosis made with the truth's effect removed from the catalogue. True if one cause, with or
/// without look-alikes, is named that is not a look-alike of the truth.
bool blamesWrongCause(const SealedTruth& truth, const Diagnosis& diagnosis);

}  // namespace alidade
