#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/simulation/sealed_truth.h"

namespace alidade {

// The score of a diagnosis, with the seal open. The right answer depends on what the readings could show:
//
//   none: the verdict is within-noise
//   faint (below `clearVisibility` σ): the verdict is within-noise, or the effect or a look-alike is first
//   unique (a visible effect without look-alikes): the effect is the first cause
//   look-alikes (a visible effect with look-alikes): the effect is the first cause or in the group of the
//     first cause, and at most one other member of that group is not its look-alike
//   gross_error: exactly the wrong readings are named, and nothing else
//   two_causes: both causes are named; further causes may be named, too
//   unknown, and an own effect that the session does not state: the verdict is not-in-catalogue
//   others (the relation of the vertical circle, a jump, larger noise): the kind is the first cause
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
  /// Whether the true Δd is within Δd ± U with the causes found. Absent without a named cause or without Δd.
  std::optional<bool> covered = {};
  /// As `covered`, but also without a named cause; the same for Δd, measured. Absent without Δd.
  std::optional<bool> coveredAfter = {}, coveredMeasured = {};
  /// Whether the causes found bring reduced χ² to noise level (p above 0.1 %). Absent without a named cause.
  std::optional<bool> backToNoise = {};
};

TrialClass classOf(const SealedTruth& truth);

TrialScore scoreTrial(const SealedTruth& truth, const Diagnosis& diagnosis);

/// Checks a diagnosis made with the truth's effect removed from the catalogue. True if the diagnosis names
/// one cause, with or without look-alikes, and this cause is not a look-alike of the truth.
bool blamesWrongCause(const SealedTruth& truth, const Diagnosis& diagnosis);

}  // namespace alidade
