#include <cmath>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/effects/cause_ids.h"
#include "core/statement/gap.h"
#include "core/wording/budget.h"
#include "core/wording/effect_name.h"
#include "core/wording/size_text.h"

namespace alidade {

namespace {

/// "without 2 misread values": each stage of misread values excludes more values.
std::string withoutGrossErrors(const Gap& gap, const GapStage& stage) {
  std::size_t all = 0, leftOut = 0;
  for (const GapStage& other : gap.stages) {
    if (other.effect == grossErrorId) all += other.grossErrors;
    if (&other == &stage) leftOut = all;
  }
  if (all == 1) return Phrase::of("without the misread value");
  return leftOut == 1 ? Phrase::of("without 1 misread value")
                      : Phrase::of("without %1 misread values", leftOut);
}

/// The model at this stage: "fit only", "in the model: gravity sag", "+ collimation".
std::string nameOf(const Gap& gap, const GapStage& stage) {
  if (stage.kind == GapStage::Kind::Bare)
    return gap.asModelled().kind == GapStage::Kind::Bare ? Phrase::of("fit only")
                                                         : Phrase::of("without model effects");
  if (stage.effect == grossErrorId) return withoutGrossErrors(gap, stage);
  if (stage.effect == knownId) return Phrase::of("+ known sizes");
  const std::string name = causeName(stage.effect);
  return stage.kind == GapStage::Kind::InModel ? Phrase::of("in the model: %1", name) : "+ " + name;
}

std::string estimateText(const std::optional<IntersectionEstimate>& estimate) {
  return estimate ? sizeWithExpanded(estimate->value, estimate->expanded, "") : "—";
}

Statement::Row rowOf(std::string name, double rms, double reducedChiSquare,
                     const std::optional<IntersectionEstimate>& estimate) {
  return {.cells = {std::move(name), displayText(rms, 2), displayText(reducedChiSquare, 2),
                    estimateText(estimate)}};
}

/// What Δd with the causes includes.
std::string averagingSentence(const Diagnosis& diagnosis) {
  if (!diagnosis.forms.empty())
    return Phrase::of(
        "Δd with the form is averaged over the indistinguishable forms; their cause is unknown.");
  if (diagnosis.shape)
    return Phrase::of(
        "U includes the possible effect of the pattern on Δd; the cause of the pattern is unknown.");
  if (beyondTheFit(diagnosis) == Beyond::Nothing) return "";
  return Phrase::of(
      "Δd with the causes is averaged over all possible explanations, weighted by their probabilities; the "
      "first alone would give too small a U.");
}

std::string shrinkageSentence(const Diagnosis& diagnosis) {
  constexpr double noticeable = 0.005;
  const Shrinkage& shrink = diagnosis.shrink;
  if (diagnosis.steps.empty() || shrink.inSample <= noticeable) return "";
  const std::string all = displayText(100 * shrink.inSample, 0);
  const std::string sentence =
      std::isfinite(shrink.heldOut)
          ? Phrase::of("The residuals shrink by %1 %, by %2 % on readings held out of the fit.", all,
                       displayText(100 * shrink.heldOut, 0))
          : Phrase::of("The residuals shrink by %1 %; there are too few readings to hold any out of the fit.",
                       all);
  // In the table each arc has its own radius, so that its residuals show no misclosure.
  const double apart = 1 - diagnosis.after.rms / diagnosis.gap.rms;
  constexpr double alike = 0.05;
  if (std::abs(apart - shrink.inSample) < alike) return sentence;
  return Phrase::of("With one rigid arc in both positions: %1", sentence);
}

}  // namespace

Statement gapStages(const Gap& gap) {
  const Diagnosis& diagnosis = *gap.diagnosis;
  Statement statement{.id = "stages",
                      .title = Phrase::of("Before and after"),
                      .columns = {{"stage", Phrase::of("Model"), Statement::Column::Role::Name},
                                  {"rms", Phrase::of("rms ″")},
                                  {"reduced_chi2", "χ²/f"},
                                  {"intersection", "Δd ± U (mm)"}},
                      .rows = {}};
  std::vector<Statement::Row>& rows = statement.rows;
  for (const GapStage& stage : gap.stages)
    rows.push_back(rowOf(nameOf(gap, stage), stage.rms, stage.reducedChiSquare, stage.intersection));
  if (std::string beyond = textOf(beyondTheFit(diagnosis)); !beyond.empty())
    rows.push_back(rowOf(std::move(beyond), diagnosis.after.rms, diagnosis.after.reducedChiSquare,
                         diagnosis.afterwards));
  rows.push_back(rowOf(Phrase::of("measured"), NAN, NAN,
                       gap.measured() ? std::optional(gap.measured()->estimate) : std::nullopt));
  rows.back().isTotal = true;
  for (std::string sentence : {shrinkageSentence(diagnosis), averagingSentence(diagnosis)})
    if (!sentence.empty()) statement.sentences.push_back(std::move(sentence));
  statement.note = Phrase::of(
      "The stated noise alone would leave residuals of %1″. Δd, measured, includes every catalogued effect, "
      "limited by these readings or by its plausible size.",
      displayText(gap.noiseRms, 2));
  return statement;
}

}  // namespace alidade
