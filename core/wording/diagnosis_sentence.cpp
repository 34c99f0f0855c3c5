#include "core/wording/diagnosis_sentence.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/effects/cause_ids.h"
#include "core/session/face.h"
#include "core/session/protocol_progress.h"
#include "core/wording/effect_name.h"
#include "core/wording/findings.h"
#include "core/wording/guidance.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

/// Whether the first cause reduces the residuals. Larger noise explains them but does not reduce them.
bool shrinks(const Diagnosis& diagnosis) {
  return diagnosis.causes.front().effect != noiseId;
}

/// The change of the residuals, unweighted, in arcseconds. If they do not shrink, also that of reduced χ²,
/// which may decrease alone if the σ of the two circles differ much.
std::string change(const GapSize& before, const GapSize& after) {
  const auto differ = [&](int decimals) {
    return displayText(before.rms, decimals) != displayText(after.rms, decimals);
  };
  const int decimals = differ(1) ? 1 : 2;
  const std::string from = displayText(before.rms, decimals), to = displayText(after.rms, decimals);
  if (after.rms < before.rms && differ(2))
    return Phrase::of("the residuals shrink from %1″ to %2″", from, to);
  const std::string same = displayText(after.rms, 2);
  if (std::isnan(after.reducedChiSquare))
    return differ(2) ? Phrase::of("the residuals grow from %1″ to %2″", from, to)
                     : Phrase::of("the residuals stay at %1″", same);
  const std::string fewer = displayText(before.reducedChiSquare, 2),
                    more = displayText(after.reducedChiSquare, 2);
  return differ(2)
             ? Phrase::of("reduced χ² changes from %1 to %2; the unweighted residuals grow from %3″ to %4″",
                          fewer, more, from, to)
             : Phrase::of("reduced χ² changes from %1 to %2; the unweighted residuals stay at %3″", fewer,
                          more, same);
}

/// Whether a closure failed before, and every closure is satisfied with the causes.
bool closes(const Diagnosis& diagnosis) {
  const auto failed = [](const ClosureStep& step) { return fails(step.before); };
  return std::ranges::any_of(diagnosis.closures, failed) && !isMisclosed(diagnosis);
}

std::string shrunk(const Diagnosis& diagnosis) {
  const std::string& first = diagnosis.causes.front().effect;
  if (!shrinks(diagnosis))
    return Phrase::of("The readings scatter %1 times as much as stated, without a pattern.",
                      displayText(diagnosis.causes.front().parameters.front().value, 1));
  const std::string residuals = change(diagnosis.gap, diagnosis.after);
  const bool changes = displayText(diagnosis.gap.rms, 1) != displayText(diagnosis.after.rms, 1);
  const std::string effect = !closes(diagnosis) ? residuals
                             : changes          ? Phrase::of("the two positions agree, and %1", residuals)
                                                : Phrase::of("the two positions agree");
  if (first == grossErrorId && diagnosis.causes.size() == 1)
    return Phrase::of("Without the misread values, %1.", effect);
  return diagnosis.causes.size() == 1 ? Phrase::of("With the cause in the model, %1.", effect)
                                      : Phrase::of("With the causes in the model, %1.", effect);
}

std::string causesNamed(const Diagnosis& diagnosis) {
  std::vector<std::string> ids;
  for (const Cause& cause : diagnosis.causes) ids.push_back(cause.effect);
  return causeNames(ids, Phrase::of(" and "));
}

std::string unexplained(const Diagnosis& diagnosis) {
  const std::string causes = causesNamed(diagnosis);
  if (!diagnosis.shape || !diagnosis.forms.empty())
    return causes.empty()
               ? Phrase::of("The gap is real, and no effect of the catalogue explains it.")
               : Phrase::of("Besides %1 there is a real gap that no effect of the catalogue explains.",
                            causes);
  const std::string pattern = patternName(*diagnosis.shape);
  return causes.empty()
             ? Phrase::of(
                   "The gap is real, and no effect of the catalogue explains it; it follows the pattern "
                   "“%1”.",
                   pattern)
             : Phrase::of(
                   "Besides %1 there is a real gap that no effect of the catalogue explains; it follows the "
                   "pattern “%2”.",
                   causes, pattern);
}

Problem kindProblem(const NoModel& fault) {
  if (!fault.why) return {Phrase::of("there are no readings; enter the readings of the axis positions")};
  Finding finding = inWords(*fault.why);
  return {std::move(finding.text), std::move(finding.where)};
}

Problem kindProblem(const UnknownCause& fault) {
  return {Phrase::of("there is no effect “%1” in the catalogue", fault.id)};
}

Problem kindProblem(const Stopped&) {
  return {Phrase::of("the diagnosis was stopped")};
}

}  // namespace

std::string patternName(const GapShape& shape) {
  return Phrase::of(shape.follows.c_str());
}

std::string headlineOf(const Diagnosis& diagnosis) {
  const std::vector<Cause>& causes = diagnosis.causes;
  switch (diagnosis.verdict) {
    case DiagnosisVerdict::WithinNoise:
      return isMisclosed(diagnosis) ? Phrase::of("The positions do not agree")
                                    : Phrase::of("No gap: within the noise");
    case DiagnosisVerdict::SingleCause:
      return Phrase::of("One cause: %1", causeName(causes.front().effect));
    case DiagnosisVerdict::Ambiguous:
      return Phrase::of("One of %1 causes indistinguishable here",
                        causes.front().indistinguishableFrom.size() + 1);
    case DiagnosisVerdict::SeveralCauses:
      return diagnosis.hasMoreCausesThanSeparable ? Phrase::of("More causes than these readings can separate")
                                                  : Phrase::of("%1 causes", causes.size());
    case DiagnosisVerdict::NotInCatalogue:
      break;
  }
  if (causes.empty()) return Phrase::of("A gap of no known cause");
  return causes.size() == 1 ? Phrase::of("An unknown cause and %1", causeName(causes.front().effect))
                            : Phrase::of("An unknown cause and %1 known ones", causes.size());
}

std::string readingName(const ReadingDeviation& reading) {
  if (reading.isZero) {
    PlannedSighting zero;
    zero.isZero = true;
    zero.isAfter = reading.isAfter;
    zero.face = reading.face;
    return listed({positionName(reading.axisDeg, reading.repeat), sightingName(zero), inWords(reading.kind)});
  }
  std::vector<std::string> where{positionName(reading.axisDeg, reading.repeat),
                                 Phrase::of("point %1", reading.point), inWords(reading.kind)};
  if (reading.round != 1) where.push_back(Phrase::of("round %1", reading.round));
  if (reading.face != 1) where.push_back(faceName(reading.face));
  return listed(where);
}

std::string secondsWithSign(double arcseconds) {
  const std::string text = displayText(arcseconds, 1) + "″";
  return text.starts_with("0.0") || arcseconds < 0 ? text : "+" + text;
}

namespace {

/// Whether the known sizes explain the gap: they reduce the residuals noticeably, and the rest is noise.
bool isAsKnown(const Diagnosis& diagnosis) {
  constexpr double noticeably = 0.9;
  return !diagnosis.known.empty() && diagnosis.after.rms < noticeably * diagnosis.gap.rms;
}

std::string asKnown(const Diagnosis& diagnosis) {
  std::vector<std::string> ids;
  for (const KnownCheck& check : diagnosis.known)
    if (std::ranges::find(ids, check.effect) == ids.end()) ids.push_back(check.effect);
  //: effects, then "the residuals shrink from 12.0″ to 2.0″"
  return Phrase::of(
      "The known sizes (%1) explain the gap: with them %2, and the rest is within the stated noise.",
      causeNames(ids, Phrase::of(" and ")), change(diagnosis.gap, diagnosis.after));
}

std::string moreThanSeparable(const Diagnosis& diagnosis) {
  //: "the residuals shrink from 12.0″ to 2.0″"
  const std::string sentence = Phrase::of(
      "There are more causes than these readings can separate. With every effect of the catalogue at a "
      "plausible size, %1.",
      change(diagnosis.gap, diagnosis.after));
  if (diagnosis.causes.empty()) return sentence;
  return Phrase::of("%1 Only this is certain: %2.", sentence, causesNamed(diagnosis));
}

std::string verdictSentenceOf(const Diagnosis& diagnosis) {
  switch (diagnosis.verdict) {
    case DiagnosisVerdict::WithinNoise:
      if (std::isnan(diagnosis.gap.pValue))
        return Phrase::of(
            "Nothing checks the model: these readings only just determine the circles. Sight more places.");
      if (isAsKnown(diagnosis)) return asKnown(diagnosis);
      return Phrase::of(
          "The readings agree with the model within their stated noise: there is no gap to explain.");
    case DiagnosisVerdict::SingleCause:
      return Phrase::of("The gap is best explained by %1. %2", causesNamed(diagnosis), shrunk(diagnosis));
    case DiagnosisVerdict::Ambiguous:
      return Phrase::of(
          "The gap is best explained by %1 or by an indistinguishable cause: %2. %3", causesNamed(diagnosis),
          causeNames(diagnosis.causes.front().indistinguishableFrom, Phrase::of(" or ")), shrunk(diagnosis));
    case DiagnosisVerdict::SeveralCauses:
      if (diagnosis.hasMoreCausesThanSeparable) return moreThanSeparable(diagnosis);
      return Phrase::of("The gap is best explained by several causes together: %1. %2",
                        causesNamed(diagnosis), shrunk(diagnosis));
    case DiagnosisVerdict::NotInCatalogue:
      return unexplained(diagnosis);
  }
  return {};
}

}  // namespace

std::string sentenceOf(const Diagnosis& diagnosis) {
  const std::string verdict = verdictSentenceOf(diagnosis), stale = staleSentence(diagnosis);
  return stale.empty() ? verdict : Phrase::of("%1 %2", verdict, stale);
}

Problem problemOf(const NoModel& fault) {
  return kindProblem(fault);
}

Problem problemOf(const DiagnosisFault& fault) {
  return std::visit([](const auto& kind) { return kindProblem(kind); }, fault);
}

}  // namespace alidade
