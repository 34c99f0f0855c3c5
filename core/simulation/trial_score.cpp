#include "core/simulation/trial_score.h"

#include <algorithm>
#include <cmath>

#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

bool holds(const std::vector<std::string>& ids, const std::string& id) {
  return std::ranges::find(ids, id) != ids.end();
}

bool isNamed(const Diagnosis& diagnosis, const std::string& id) {
  return std::ranges::find(diagnosis.causes, id, &Cause::effect) != diagnosis.causes.end();
}

/// True if `id` is the first cause or one of its look-alikes.
bool isFirst(const Diagnosis& diagnosis, const std::string& id) {
  if (diagnosis.causes.empty()) return false;
  const Cause& first = diagnosis.causes.front();
  return first.effect == id || holds(first.indistinguishableFrom, id);
}

/// The number of look-alikes of the first cause that are neither the truth nor one of its look-alikes.
std::ptrdiff_t strangersIn(const Diagnosis& diagnosis, const SealedTruth& truth) {
  return std::ranges::count_if(diagnosis.causes.front().indistinguishableFrom, [&](const std::string& id) {
    return id != truth.kind && !holds(truth.lookAlikes, id);
  });
}

std::vector<GrossErrorCell> cellsOf(const Diagnosis& diagnosis) {
  std::vector<GrossErrorCell> cells;
  for (const Cause& cause : diagnosis.causes)
    for (const ReadingDeviation& reading : cause.readings)
      cells.push_back(
          {reading.axisDeg, reading.round, reading.point, reading.face, reading.kind, reading.repeat});
  std::ranges::sort(cells);
  return cells;
}

bool isRight(TrialClass trialClass, const SealedTruth& truth, const Diagnosis& diagnosis) {
  const bool named = !diagnosis.causes.empty();
  const auto isCause = [&](const std::string& id) { return isNamed(diagnosis, id); };
  switch (trialClass) {
    case TrialClass::None:
      return diagnosis.verdict == DiagnosisVerdict::WithinNoise;
    case TrialClass::Faint:
      return diagnosis.verdict == DiagnosisVerdict::WithinNoise ||
             (named && (diagnosis.causes.front().effect == truth.kind ||
                        holds(truth.lookAlikes, diagnosis.causes.front().effect)));
    case TrialClass::Unique:
    case TrialClass::Other:
      return named && diagnosis.causes.front().effect == truth.kind;
    case TrialClass::LookAlikes:
      return isFirst(diagnosis, truth.kind) && strangersIn(diagnosis, truth) <= 1;
    case TrialClass::GrossError:
      return diagnosis.causes.size() == 1 && isCause(truth.kind) && cellsOf(diagnosis) == truth.grossErrors;
    case TrialClass::SeveralCauses:
      return !truth.causes.empty() && std::ranges::all_of(truth.causes, isCause);
    case TrialClass::Unknown:
      return diagnosis.verdict == DiagnosisVerdict::NotInCatalogue;
  }
  return false;
}

/// True if the interval contains the true Δd; absent without an estimate.
std::optional<bool> covers(const std::optional<IntersectionEstimate>& estimate, const SealedTruth& truth) {
  if (!estimate) return std::nullopt;
  return std::abs(estimate->value - truth.intersection) <= estimate->expanded;
}

std::string answerOf(const Diagnosis& diagnosis) {
  if (diagnosis.causes.empty()) return std::string(nameOf(diagnosis.verdict));
  return diagnosis.causes.size() == 1 ? diagnosis.causes.front().effect : "several-causes";
}

}  // namespace

std::string_view nameOf(TrialClass trialClass) {
  switch (trialClass) {
    case TrialClass::None:
      return "none";
    case TrialClass::Faint:
      return "faint";
    case TrialClass::Unique:
      return "unique";
    case TrialClass::LookAlikes:
      return "look-alikes";
    case TrialClass::GrossError:
      return grossErrorId;
    case TrialClass::SeveralCauses:
      return "several causes";
    case TrialClass::Unknown:
      return "unknown";
    case TrialClass::Other:
      return "others";
  }
  return "";
}

TrialClass classOf(const SealedTruth& truth) {
  if (truth.kind == "none") return TrialClass::None;
  if (truth.kind == grossErrorId) return TrialClass::GrossError;
  if (isOfNoCatalogue(truth.kind) && !truth.statesOwn) return TrialClass::Unknown;
  if (truth.causes.size() > 1) return TrialClass::SeveralCauses;
  if (!truth.visible) return TrialClass::Other;
  if (*truth.visible < clearVisibility) return TrialClass::Faint;
  return truth.lookAlikes.empty() ? TrialClass::Unique : TrialClass::LookAlikes;
}

TrialScore scoreTrial(const SealedTruth& truth, const Diagnosis& diagnosis) {
  constexpr double leastChance = 0.001;
  TrialScore score{.trialClass = classOf(truth), .answer = answerOf(diagnosis)};
  score.right = isRight(score.trialClass, truth, diagnosis);
  score.detected = diagnosis.verdict != DiagnosisVerdict::WithinNoise;
  score.named = isFirst(diagnosis, truth.kind);
  score.coveredAfter = covers(diagnosis.afterwards, truth);
  if (diagnosis.measured) score.coveredMeasured = covers(diagnosis.measured->estimate, truth);
  if (diagnosis.causes.empty()) return score;
  score.backToNoise = diagnosis.after.pValue > leastChance;
  score.covered = score.coveredAfter;
  return score;
}

bool blamesWrongCause(const SealedTruth& truth, const Diagnosis& diagnosis) {
  const bool single =
      diagnosis.verdict == DiagnosisVerdict::SingleCause || diagnosis.verdict == DiagnosisVerdict::Ambiguous;
  return single && !holds(truth.lookAlikes, diagnosis.causes.front().effect);
}

}  // namespace alidade
