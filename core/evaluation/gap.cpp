#include "core/evaluation/gap.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/diagnosis/diagnose.h"
#include "core/effects/catalogue.h"

namespace alidade {

namespace {

/// Root mean square of a quantity of the circle readings, arcseconds.
template <typename Square>
double rmsOf(const JointFit& fit, Square square) {
  double sum = 0;
  int count = 0;
  for (const AdjustedReading& reading : fit.readings) {
    if (reading.kind == ReadingKind::Slider) continue;
    sum += square(reading);
    ++count;
  }
  return count > 0 ? Angle::fromRadians(std::sqrt(sum / count)).arcseconds() : 0;
}

GapStage stageOf(const SessionFit& fit) {
  const auto square = [](const AdjustedReading& reading) { return reading.residual * reading.residual; };
  const double f = fit.joint.degreesOfFreedom;
  GapStage stage{.rms = rmsOf(fit.joint, square),
                 .reducedChiSquare = f > 0 ? fit.joint.chiSquare / f : NAN,
                 .intersection = {}};
  if (fit.intersection) stage.intersection = estimateOf(*fit.intersection);
  return stage;
}

/// Absent if a diagnosis is possible.
std::optional<NoDiagnosis> reasonForNone(const Evaluation& evaluation) {
  const SessionFit& fit = evaluation.fit;
  if (evaluation.failure) return *evaluation.failure;
  if (fit.arcs.empty()) return Absence::NothingToCompare;
  if (fit.joint.degreesOfFreedom <= 0) return Absence::NothingLeftOver;
  return std::nullopt;
}

/// The bare model, then with one more effect of the session at each stage.
std::vector<GapStage> modelledStages(const Evaluation& evaluation, const std::stop_token& stop) {
  std::vector<GapStage> stages;
  Measurement measurement = *evaluation.examined.measurement;
  const std::vector<std::string> effects = std::exchange(measurement.effects, {});
  const auto isKnown = [&](const std::string& id) { return effectById(id, measurement) != nullptr; };
  const auto known = std::count_if(effects.begin(), effects.end(), isKnown);
  if (known > 0) stages.push_back(stageOf(fitSession(measurement)));
  for (const std::string& id : effects) {
    if (!isKnown(id)) continue;
    if (stop.stop_requested()) return stages;
    measurement.effects.push_back(id);
    const bool isLast = static_cast<std::ptrdiff_t>(measurement.effects.size()) == known;
    stages.push_back(stageOf(isLast ? evaluation.fit : fitSession(measurement)));
    stages.back().kind = GapStage::Kind::InModel;
    stages.back().effect = id;
  }
  if (known == 0) stages.push_back(stageOf(evaluation.fit));
  return stages;
}

}  // namespace

const GapStage& Gap::asModelled() const {
  const auto isModelled = [](const GapStage& stage) { return stage.kind != GapStage::Kind::Proposed; };
  return *std::find_if(stages.rbegin(), stages.rend(), isModelled);
}

bool Gap::isNoiseAlone() const {
  return isOpen() && !isMoreThanNoise(*diagnosis);
}

std::optional<double> Gap::expandedUncertainty() const {
  if (const MeasuredIntersection* result = measured()) return result->estimate.expanded;
  return diagnosis && diagnosis->before ? std::optional(diagnosis->before->expanded) : std::nullopt;
}

std::vector<UndetectableEffect> undetectableBeyond(const Diagnosis& diagnosis, double expanded) {
  std::vector<UndetectableEffect> effects = diagnosis.undetectable;
  std::erase_if(effects, [&](const UndetectableEffect& effect) { return effect.influence <= expanded; });
  return effects;
}

std::vector<UndetectableEffect> Gap::undetectableBeyondU() const {
  const std::optional<double> expanded = expandedUncertainty();
  if (!expanded) return {};
  return undetectableBeyond(*diagnosis, *expanded);
}

std::vector<UndetectableEffect> Gap::noticeablyUndetectable() const {
  constexpr std::size_t most = 8;
  constexpr double noticeable = 0.02;
  if (!diagnosis) return {};
  const double expanded = expandedUncertainty().value_or(0);
  std::vector<UndetectableEffect> effects = diagnosis->undetectable;
  std::erase_if(effects,
                [&](const UndetectableEffect& effect) { return effect.influence < noticeable * expanded; });
  effects.resize(std::min(most, effects.size()));
  return effects;
}

namespace {

/// A piece of advice, its information relative to the best of its kind, and its effort in sessions.
struct Offer {
  const Advice* advice;
  double tells, effort;

  bool beats(const Offer& other) const {
    return advice->ofUndetectable == other.advice->ofUndetectable && effort <= other.effort &&
           tells >= other.tells && (effort < other.effort || tells > other.tells || advice < other.advice);
  }
};

double toldBy(const Diagnosis& diagnosis, const Advice& advice) {
  if (!advice.ofUndetectable) return std::round(20 * advice.oneLeft);  // a twentieth is no difference
  double variance = 0;
  for (const UndetectableEffect& effect : diagnosis.undetectable)
    if (std::ranges::find(advice.separates, effect.effect) != advice.separates.end())
      variance += effect.influence * effect.influence;
  return std::sqrt(variance);
}

/// Keeps the cheapest, the most informative, and between them the most informative for their effort.
void keepFew(std::vector<Offer>& offers) {
  constexpr std::size_t most = 3;
  while (offers.size() > most) {
    const auto worst = std::min_element(
        offers.begin() + 1, offers.end() - 1,
        [](const Offer& a, const Offer& b) { return a.tells * b.effort < b.tells * a.effort; });
    offers.erase(worst);
  }
}

}  // namespace

std::vector<Advice> worthwhileAdvice(const Diagnosis& diagnosis) {
  std::vector<Offer> all, frontier;
  double best[2] = {0, 0};
  for (const Advice& advice : diagnosis.advice) {
    all.push_back({&advice, toldBy(diagnosis, advice), effortOf(advice.measures)});
    double& most = best[advice.ofUndetectable ? 1 : 0];
    most = std::max(most, all.back().tells);
  }
  for (Offer& offer : all)
    if (const double most = best[offer.advice->ofUndetectable ? 1 : 0]; most > 0) offer.tells /= most;
  std::ranges::copy_if(all, std::back_inserter(frontier), [&](const Offer& offer) {
    return std::ranges::none_of(all, [&](const Offer& other) { return other.beats(offer); });
  });
  std::ranges::stable_sort(frontier, {},
                           [](const Offer& offer) { return std::pair(offer.effort, offer.tells); });
  keepFew(frontier);
  std::vector<Advice> few;
  for (const Offer& offer : frontier) few.push_back(*offer.advice);
  return few;
}

Gap withDependences(Gap gap, const std::stop_token& stop) {
  if (gap.dependences) return gap;
  std::vector<Dependence> rows;
  if (const SessionFit& fit = gap.evaluation->fit; fit.intersection)
    rows = dependencesOf(*gap.evaluation->examined.measurement, fit, gap.found(), stop);
  if (!stop.stop_requested()) gap.dependences = std::move(rows);
  return gap;
}

Gap noGap(SharedEvaluation evaluation, NoDiagnosis reason) {
  return {.evaluation = std::move(evaluation), .diagnosis = {}, .reason = std::move(reason), .stages = {}};
}

Gap gapOf(SharedEvaluation evaluation, Diagnosis diagnosis, const std::stop_token& stop) {
  Gap gap = noGap(std::move(evaluation), Absence::NotMade);
  gap.stages = modelledStages(*gap.evaluation, stop);
  for (const GapStep& step : diagnosis.steps) {
    const auto cause = std::ranges::find(diagnosis.causes, step.effect, &Cause::effect);
    gap.stages.push_back({.kind = GapStage::Kind::Proposed,
                          .effect = step.effect,
                          .grossErrors = cause == diagnosis.causes.end() ? 0 : cause->readings.size(),
                          .rms = step.size.rms,
                          .reducedChiSquare = step.size.reducedChiSquare,
                          .intersection = step.intersection});
  }
  gap.noiseRms = rmsOf(gap.evaluation->fit.joint, [](const AdjustedReading& reading) {
    return reading.redundancy * reading.sigma * reading.sigma;
  });
  gap.diagnosis = std::move(diagnosis);
  return gap;
}

Gap assessGap(const SharedEvaluation& evaluation, const std::stop_token& stop, bool withReference) {
  if (auto reason = reasonForNone(*evaluation)) return noGap(evaluation, *std::move(reason));
  auto diagnosis = diagnose(*evaluation->examined.measurement, evaluation->fit,
                            {.withReference = withReference, .withAttainable = true}, stop);
  Gap gap =
      diagnosis ? gapOf(evaluation, *std::move(diagnosis), stop) : noGap(evaluation, diagnosis.problem());
  gap.isWithReference = withReference;
  return gap;
}

}  // namespace alidade
