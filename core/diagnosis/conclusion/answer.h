#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/conclusion/rivals.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// The conclusion from the explanations of an inquiry.

/// Every effect of the catalogue at its plausible size, as an alternative to the likeliest pattern.
struct EveryEffect {
  double chance = 0;  ///< probability of these effects instead of the pattern, 0…1
  GapModel closed, opened;
};

struct Answer {
  /// `Several`: more causes than these readings can separate. All effects of the catalogue at their plausible
  /// size are together as likely as any pattern.
  enum class Kind { Nothing, Known, Unknown, Several };

  Kind kind = Kind::Nothing;
  /// The causes that are certain in addition to the pattern (Unknown) or to the effects (Several).
  Explanation explanation;
  std::vector<std::vector<Rival>> rivals;  ///< rivals of each part of the explanation
  std::optional<Part> pattern;             ///< with Unknown: the likeliest pattern; absent if the readings
                                           ///< do not determine the model of the answer
  GapModel after;                          ///< the model with the explanation and, with Several, every effect
  /// The model whose Δd is reported: `after`, or the session's own model if the explanation contains only
  /// gross errors and larger noise.
  GapModel measured = {};
  GapModel opened = {};  ///< the session's own model with the causes of `measured` (`openedModelOf`)
  std::optional<EveryEffect> everyEffect = {};
};

/// Chooses the kind of answer that is likeliest in total: no cause, known causes, or a pattern without a
/// known cause. Returns an Unknown without parts if the readings do not determine the model of that choice.
Answer conclude(const Inquiry& inquiry);

/// `closed`: the model with an explanation but without its pattern. `opened`: the session's own model with
/// the same causes (`openedModelOf`).
struct ExplainedModel {
  GapModel closed, opened;
};
ExplainedModel explainedModel(const Inquiry& inquiry, Explanation explanation);

/// The gap after each step: known sizes, then the exclusion of gross errors, then each further part of the
/// explanation, larger noise and forms.
std::vector<GapStep> stepsOf(const Inquiry& inquiry, const Answer& answer);

}  // namespace alidade
