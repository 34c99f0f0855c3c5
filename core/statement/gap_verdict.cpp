#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/statement/gap.h"
#include "core/wording/closures.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/effect_name.h"

namespace alidade {

namespace {

/// The residuals without the effects of the model; empty if it has none.
std::string modelSentence(const Gap& gap) {
  const GapStage& bare = gap.stages.front();
  if (bare.kind != GapStage::Kind::Bare || &bare == &gap.asModelled()) return "";
  std::vector<std::string> effects;
  for (const GapStage& stage : gap.stages)
    if (stage.kind == GapStage::Kind::InModel) effects.push_back(stage.effect);
  return Phrase::of("The model includes %1; without it, the residuals are %2 instead of %3.",
                    causeNames(effects, Phrase::of(" and ")), displayText(bare.rms, 1) + "″",
                    displayText(gap.asModelled().rms, 1) + "″");
}

std::string wordsOf(Absence absence) {
  switch (absence) {
    case Absence::NotMade:
      break;
    case Absence::Stopped:
      return Phrase::of("The diagnosis was stopped. The next edit starts it again.");
    case Absence::NothingToCompare:
      return Phrase::of(
          "There is nothing to compare yet: type the distance L, the radius R0, a pointing zero and at least "
          "three readings of its arc.");
    case Absence::NothingLeftOver:
      return Phrase::of(
          "These readings only just determine the arc. Type further readings: each of them checks the "
          "model.");
  }
  return "";
}

}  // namespace

std::string reasonForNone(const Gap& gap) {
  if (const auto* absence = std::get_if<Absence>(&gap.reason)) return wordsOf(*absence);
  if (const auto* failed = std::get_if<FailedWork>(&gap.reason)) return sentencesOf(*failed);
  return problemOf(std::get<DiagnosisFault>(gap.reason)).what;
}

Statement gapVerdict(const Gap& gap) {
  const Diagnosis& diagnosis = *gap.diagnosis;
  Statement statement{.id = "gap",
                      .title = headlineOf(diagnosis),
                      .columns = {},
                      .rows = {},
                      .sentences = {sentenceOf(diagnosis)}};
  if (diagnosis.verdict == DiagnosisVerdict::WithinNoise && isMisclosed(diagnosis))
    statement.sentences.push_back(misclosureSentence(diagnosis));
  if (std::string sentence = modelSentence(gap); !sentence.empty())
    statement.sentences.push_back(std::move(sentence));
  return statement;
}

}  // namespace alidade
