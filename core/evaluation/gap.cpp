#include "core/evaluation/gap.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/diagnosis/diagnose.h"
#include "core/effects/catalogue.h"

namespace alidade {

namespace {

/// Root mean square of a quantity of the circle readings, arcseconds; `square` returns its square in rad².
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

/// Why no diagnosis is possible; absent if one is possible.
std::optional<NoDiagnosis> reasonForNone(const Evaluation& evaluation) {
  const SessionFit& fit = evaluation.fit;
  if (evaluation.failure) return *evaluation.failure;
  if (fit.arcs.empty()) return Absence::NothingToCompare;
  if (fit.joint.degreesOfFreedom <= 0 && !fit.intersection) return Absence::NothingLeftOver;
  return std::nullopt;
}

/// The stage of the bare model, then one stage for each effect that the session adds to the model.
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
