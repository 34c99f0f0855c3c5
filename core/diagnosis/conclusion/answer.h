#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/conclusion/rivals.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// What the explanations of an inquiry come to.

/// Every effect of the catalogue at its plausible size, where a pattern is the likeliest without them.
struct EveryEffect {
  double chance = 0;  ///< that they are what is there, not the pattern; 0…1
  GapModel closed, opened;
};

struct Answer {
  /// `Several`: more causes than these readings can take apart, all effects of the catalogue at their
  /// plausible size being together as likely as any pattern.
  enum class Kind { Nothing, Known, Unknown, Several };

  Kind kind = Kind::Nothing;
  /// Of an Unknown: what is certain beside the pattern; of Several: beside the effects.
  Explanation explanation;
  std::vector<std::vector<Rival>> rivals;  ///< of each part of the explanation
  std::optional<Part> pattern;             ///< of an Unknown: the likeliest; absent where nothing fits at all
  GapModel after;  ///< with the explanation in the model; of Several with every effect, too
  /// Whose Δd is told: `after`, or the session's own model where nothing but readings and noise is blamed.
  GapModel measured = {};
  GapModel opened = {};  ///< what `measured` leaves in the session's own model (`openedModelOf`)
  std::optional<EveryEffect> everyEffect = {};
};

/// Whichever of nothing, known causes and a pattern of no known cause is the most likely as a whole; an
/// Unknown without any part where the readings do not determine a model with the likeliest.
Answer conclude(const Inquiry& inquiry);

/// A model with an explanation in it (but for a pattern, which no model holds), and what that leaves in the
/// session's own model (`openedModelOf`).
struct ExplainedModel {
  GapModel closed, opened;
};
ExplainedModel explainedModel(const Inquiry& inquiry, Explanation explanation);

/// The gap after each cause: without all readings blamed, then with each part of the explanation added.
std::vector<GapStep> stepsOf(const Inquiry& inquiry, const Answer& answer);

}  // namespace alidade
