#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/inquiry.h"

namespace alidade {

// What the explanations of an inquiry come to, for the .cpp files of this room only.

struct Answer {
  enum class Kind { Nothing, Known, Unknown };

  Kind kind = Kind::Nothing;
  Explanation explanation;  ///< of a Known; else empty
  /// Of each part of the explanation, what these readings cannot tell from it: effects, of a misreading the
  /// step that only its row would show. Indices of candidates.
  std::vector<std::vector<std::size_t>> lookAlikes;
  std::vector<Explanation>
      rivals;      ///< with one of those in place of what it looks like, where that is weighed
  GapModel after;  ///< with the explanation in the model
};

/// Whichever of nothing, known causes and a pattern of no known cause is the most likely as a whole.
Answer conclude(const Inquiry& inquiry);

/// Δd afterwards; where others look like the cause, averaged over all of them, each as likely as it is, with
/// what they differ by in σ.
std::optional<IntersectionEstimate> afterwardsOf(const Inquiry& inquiry, const Answer& answer);

/// The gap after each cause: without all readings blamed, then with each part of the explanation added.
std::vector<GapStep> stepsOf(const Inquiry& inquiry, const Answer& answer);

}  // namespace alidade
