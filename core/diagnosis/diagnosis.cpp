#include "core/diagnosis/diagnosis.h"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.h"
#include "core/diagnosis/advice.h"
#include "core/diagnosis/gap_model.h"
#include "core/diagnosis/held_out.h"
#include "core/diagnosis/location.h"
#include "core/diagnosis/look_alikes.h"
#include "core/diagnosis/sentence.h"
#include "core/diagnosis/unseen.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr const char *jumpId = "orientation_jump", *misreadingId = "gross_error",
                     *noiseId = "underestimated_noise";

/// One round of the search: the model it starts from, what it leaves over, and what explains that.
struct Inquiry {
  GapModel base;
  Leftover leftover;
  std::vector<Component> candidates;
  std::vector<Explanation> explanations;
};

bool considered(const DiagnosisOptions& options, std::string_view id) {
  return std::ranges::find(options.without, id) == options.without.end();
}

Inquiry inquire(GapModel base, const DiagnosisOptions& options) {
  const Linearised linear = linearise(base.measurement, base.fit, base.options);
  Leftover leftover({linear}, base.options.terms);
  SearchOptions search;
  search.misreadings = considered(options, misreadingId);
  search.noise = considered(options, noiseId);
  std::vector<std::string> leftOut = options.without;
  leftOut.insert(leftOut.end(), base.measurement.effects.begin(), base.measurement.effects.end());
  std::vector<Component> candidates = effectComponents(leftover, leftOut, search.odds);
  if (const Effect* tilt = effectById("plane_tilt"); considered(options, tilt->id)) {
    const auto tilted = [&](std::size_t p) {
      const EffectParameter& parameter = tilt->parameters[p];
      return linearisedAt(base, parameter.term, parameter.plausible * modelUnitsPer(parameter.unit));
    };
    bendPlaneTilt(candidates, leftover, tilted(0), tilted(1));
  }
  const auto append = [&](std::vector<Component> more) {
    std::ranges::move(more, std::back_inserter(candidates));
  };
  if (considered(options, jumpId)) append(jumpComponents(leftover, base.measurement, search.odds));
  append(shapeComponents(leftover, base.measurement, base.fit, options.without, search.odds));
  std::vector<Explanation> explanations = explain(leftover, candidates, search);
  return {std::move(base), std::move(leftover), std::move(candidates), std::move(explanations)};
}

bool isShape(const Inquiry& inquiry, const Part& part) {
  return part.component < inquiry.candidates.size() &&
         inquiry.candidates[part.component].kind == Component::Kind::Shape;
}

bool hasShape(const Inquiry& inquiry, const Explanation& explanation) {
  return std::ranges::any_of(explanation.parts, [&](const Part& part) { return isShape(inquiry, part); });
}

/// Readings so far off that the equations at the fit they have spoiled say little: they are taken out, and
/// the search begins anew.
std::vector<ReadingRef> farOff(const Inquiry& inquiry) {
  constexpr double farOffSigma = 300;
  std::vector<ReadingRef> found;
  for (const Part& part : inquiry.explanations.front().parts)
    if (part.component >= inquiry.candidates.size() && std::abs(part.weights[0]) > farOffSigma)
      found.push_back(readingOf(inquiry.leftover, part.component, inquiry.candidates.size()));
  return found;
}

/// How likely the kinds of answers are, 0…1 together.
struct Chances {
  double nothing = 0, known = 0, unknown = 0;
};

Chances chancesOf(const Inquiry& inquiry) {
  Chances chances;
  double sum = 0;
  for (const Explanation& explanation : inquiry.explanations) {
    const double chance = std::exp(explanation.logOdds - inquiry.explanations.front().logOdds);
    sum += chance;
    if (hasShape(inquiry, explanation))
      chances.unknown += chance;
    else if (explanation.parts.empty() && !explanation.noisy)
      chances.nothing += chance;
    else
      chances.known += chance;
  }
  return {chances.nothing / sum, chances.known / sum, chances.unknown / sum};
}

bool isPartOf(const Explanation& smaller, const Explanation& larger) {
  if (smaller.noisy && !larger.noisy) return false;
  return std::ranges::all_of(smaller.parts, [&](const Part& part) {
    return std::ranges::find(larger.parts, part.component, &Part::component) != larger.parts.end();
  });
}

/// The best explanation of known causes; a smaller one of the same causes where it is nearly as good.
const Explanation& bestKnown(const Inquiry& inquiry) {
  constexpr double nearlyAsGood = 2;  // natural logarithm: odds of 7
  const auto isKnown = [&](const Explanation& e) {
    return !hasShape(inquiry, e) && (e.noisy || !e.parts.empty());
  };
  const Explanation& best = *std::ranges::find_if(inquiry.explanations, isKnown);
  const Explanation* simplest = &best;
  const auto count = [](const Explanation& e) { return e.parts.size() + (e.noisy ? 1 : 0); };
  for (const Explanation& other : inquiry.explanations)
    if (isKnown(other) && other.logOdds > best.logOdds - nearlyAsGood && count(other) < count(*simplest) &&
        isPartOf(other, best))
      simplest = &other;
  return *simplest;
}

GapSize sizeOf(const GapModel& model) {
  double squares = 0;
  int count = 0;
  for (const AdjustedReading& reading : model.fit.readings) {
    const bool out =
        std::ranges::find(model.options.without, ReadingRef{reading.arc, reading.sighting, reading.kind}) !=
        model.options.without.end();
    if (out || reading.kind == ReadingKind::Slider) continue;
    squares += std::pow(Angle::fromRadians(reading.residual).arcseconds(), 2);
    ++count;
  }
  const double f = model.fit.degreesOfFreedom, chiSquare = model.fit.chiSquare / (model.noise * model.noise);
  return {count > 0 ? std::sqrt(squares / count) : 0, f > 0 ? chiSquare / f : 0,
          f > 0 ? chiSquareUpperTail(chiSquare, f) : 1};
}

double excessOf(const GapModel& model) {
  return std::max(0.0, model.fit.chiSquare / (model.noise * model.noise) - model.fit.degreesOfFreedom);
}

std::optional<IntersectionEstimate> estimateOf(const GapModel& model) {
  const std::optional<Intersection> found = intersect(model.measurement, model.fit);
  if (!found) return std::nullopt;
  return IntersectionEstimate{found->value, found->sigma, found->expanded};
}

BlamedReading blamed(const GapModel& model, const ReadingRef& ref, double size) {
  const ArcMeasurement& arc = model.measurement.arcs[ref.arc];
  const Sighting& sighting = arc.sightings[ref.sighting];
  return {.position = arc.position,
          .row = sighting.row,
          .axisDeg = arc.axisDeg,
          .round = sighting.round,
          .point = sighting.point,
          .face = sighting.face,
          .kind = ref.kind,
          .size = size};
}

double sigmaArcseconds(const Measurement& measurement, ReadingKind kind) {
  const Angle sigma = kind == ReadingKind::Horizontal ? measurement.sigmaHorizontal
                      : kind == ReadingKind::Vertical ? measurement.sigmaVertical
                                                      : measurement.sigmaSlider;
  return sigma.arcseconds();
}

/// Probability that the id is among the causes.
double probabilityOf(const Inquiry& inquiry, const std::string& id) {
  double with = 0, all = 0;
  for (const Explanation& explanation : inquiry.explanations) {
    const double chance = std::exp(explanation.logOdds - inquiry.explanations.front().logOdds);
    all += chance;
    const bool names =
        (id == noiseId && explanation.noisy) || std::ranges::any_of(explanation.parts, [&](const Part& part) {
          return part.component >= inquiry.candidates.size() ? id == misreadingId
                                                             : id == inquiry.candidates[part.component].id;
        });
    if (names) with += chance;
  }
  return with / all;
}

/// The explanation of one component alone, with the same noise; null where the search did not meet it.
const Explanation* alone(const Inquiry& inquiry, std::size_t component, bool noisy) {
  for (const Explanation& explanation : inquiry.explanations)
    if (explanation.parts.size() == 1 && explanation.parts[0].component == component &&
        explanation.noisy == noisy)
      return &explanation;
  return nullptr;
}

/// Effects that these readings cannot tell from a part of the explanation, by index of the candidate.
std::vector<std::size_t> lookAlikesOf(const Inquiry& inquiry, const Explanation& explanation,
                                      const Part& part) {
  constexpr double closeOdds = 3.5;  // natural logarithm: odds of 33
  std::vector<std::size_t> found;
  const VectorXd trace = signature(inquiry.candidates[part.component], part.weights);
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& other = inquiry.candidates[i];
    if (other.kind != Component::Kind::Effect || i == part.component) continue;
    const double difference = differenceFrom(trace, other) / explanation.noise;
    if (difference > clearlyDifferent) continue;
    const Explanation* rival = explanation.parts.size() == 1 ? alone(inquiry, i, explanation.noisy) : nullptr;
    const bool close = rival && rival->logOdds > explanation.logOdds - closeOdds;
    if (difference < hardlyDifferent || close) found.push_back(i);
  }
  return found;
}

void addParameters(Cause& cause, const GapModel& after, const Component& component) {
  const auto add = [&](std::string_view name, ErrorTerm term, std::string_view unit) {
    const std::size_t i = after.fit.indexOf({.kind = Unknown::Kind::Error, .arc = 0, .term = term});
    const double factor = modelUnitsPer(unit);
    cause.parameters.push_back({std::string(name), after.fit.values[i] / factor,
                                std::sqrt(after.fit.cofactor(i, i)) * after.noise / factor,
                                std::string(unit)});
  };
  if (component.kind == Component::Kind::Jump) {
    add("horizontal step", ErrorTerm::HorizontalJump, "arcsec");
    add("vertical step", ErrorTerm::VerticalJump, "arcsec");
    cause.parameters.push_back({"before row", static_cast<double>(component.moment) + 1, 0, "-"});
    return;
  }
  for (const EffectParameter& parameter : component.effect->parameters)
    add(parameter.name, parameter.term, parameter.unit);
}

std::vector<Cause> causesOf(const Inquiry& inquiry, const Explanation& explanation, const GapModel& after,
                            const std::vector<BlamedReading>& farOffReadings) {
  std::vector<Cause> causes;
  Cause misread{.effect = misreadingId,
                .probability = 1,
                .parameters = {},
                .indistinguishableFrom = {},
                .readings = farOffReadings};
  for (const Part& part : explanation.parts) {
    if (part.component >= inquiry.candidates.size()) {
      const ReadingRef ref = readingOf(inquiry.leftover, part.component, inquiry.candidates.size());
      misread.readings.push_back(
          blamed(after, ref, part.weights[0] * sigmaArcseconds(after.measurement, ref.kind)));
      continue;
    }
    const Component& component = inquiry.candidates[part.component];
    Cause cause{.effect = component.id,
                .probability = probabilityOf(inquiry, component.id),
                .parameters = {},
                .indistinguishableFrom = {},
                .readings = {}};
    addParameters(cause, after, component);
    if (component.kind == Component::Kind::Effect)
      for (const std::size_t i : lookAlikesOf(inquiry, explanation, part))
        cause.indistinguishableFrom.push_back(inquiry.candidates[i].id);
    causes.push_back(std::move(cause));
  }
  if (!misread.readings.empty()) {
    if (farOffReadings.empty()) misread.probability = probabilityOf(inquiry, misreadingId);
    causes.push_back(std::move(misread));
  }
  if (explanation.noisy)
    causes.push_back(
        {.effect = noiseId,
         .probability = probabilityOf(inquiry, noiseId),
         .parameters = {{"ratio", after.noise,
                         after.noise / std::sqrt(2.0 * std::max(1, after.fit.degreesOfFreedom)), "1"}},
         .indistinguishableFrom = {},
         .readings = {}});
  return causes;
}

/// Δd with the cause added; where others look like it, averaged over all of them, each as likely as it is,
/// with what they differ by in σ.
std::optional<IntersectionEstimate> afterwardsOf(const Inquiry& inquiry, const Explanation& explanation,
                                                 const GapModel& after) {
  const std::optional<IntersectionEstimate> first = estimateOf(after);
  if (!first || explanation.parts.size() != 1 ||
      explanation.parts[0].component >= inquiry.candidates.size() ||
      inquiry.candidates[explanation.parts[0].component].kind != Component::Kind::Effect)
    return first;
  double sum = 1, mean = first->value, second = first->sigma * first->sigma + mean * mean;
  for (const std::size_t i : lookAlikesOf(inquiry, explanation, explanation.parts[0])) {
    const Explanation* rival = alone(inquiry, i, explanation.noisy);
    if (!rival) continue;
    const double chance = std::exp(rival->logOdds - explanation.logOdds);
    if (chance < 1e-3) continue;
    const auto other = estimateOf(modelWith(inquiry.base, *rival, inquiry.candidates, inquiry.leftover));
    sum += chance;
    mean += chance * other->value;
    second += chance * (other->sigma * other->sigma + other->value * other->value);
  }
  mean /= sum;
  const double sigma = std::sqrt(std::max(second / sum - mean * mean, 0.0));
  return IntersectionEstimate{mean, sigma, sigma * (first->expanded / first->sigma)};
}

std::vector<Candidate> candidatesOf(const Inquiry& inquiry) {
  std::vector<Candidate> list;
  const auto offer = [&](const std::string& id, double log, double visible) {
    const auto same = std::ranges::find(list, id, &Candidate::effect);
    if (same == list.end())
      list.push_back({id, log, visible});
    else if (same->logBayesFactor < log)
      *same = {id, log, visible};
  };
  for (const Explanation& explanation : inquiry.explanations) {
    if (explanation.noisy && explanation.parts.empty()) offer(noiseId, explanation.logEvidence, 0);
    if (explanation.parts.size() != 1 || explanation.noisy || hasShape(inquiry, explanation)) continue;
    const Part& part = explanation.parts[0];
    if (part.component >= inquiry.candidates.size()) {
      const auto reading = static_cast<Index>(part.component - inquiry.candidates.size());
      offer(misreadingId, part.logGain,
            std::abs(part.weights[0]) * std::sqrt(inquiry.leftover.redundancy(reading)));
    } else {
      const Component& component = inquiry.candidates[part.component];
      offer(component.id, part.logGain, signature(component, part.weights).norm());
    }
  }
  for (const Component& component : inquiry.candidates)
    if (component.kind == Component::Kind::Effect &&
        std::ranges::find(list, component.id, &Candidate::effect) == list.end())
      list.push_back({component.id, logBayesFactor(inquiry.leftover, component), 0});
  std::ranges::sort(list, std::greater{}, &Candidate::logBayesFactor);
  return list;
}

std::vector<GapStep> stepsOf(const Inquiry& inquiry, const Explanation& explanation) {
  std::vector<GapStep> steps;
  Explanation soFar{.parts = {}, .noisy = false};
  const auto note = [&](const std::string& id) {
    const GapModel model = modelWith(inquiry.base, soFar, inquiry.candidates, inquiry.leftover);
    steps.push_back({id, sizeOf(model), estimateOf(model)});
  };
  for (const Part& part : explanation.parts) {
    soFar.parts.push_back(part);
    note(part.component >= inquiry.candidates.size() ? misreadingId : inquiry.candidates[part.component].id);
  }
  if (explanation.noisy) {
    soFar.noisy = true;
    note(noiseId);
  }
  return steps;
}

VectorXd perSigma(const GapModel& model) {
  VectorXd influence(static_cast<Index>(model.fit.readings.size()));
  for (Index i = 0; i < influence.size(); ++i) {
    const AdjustedReading& reading = model.fit.readings[static_cast<std::size_t>(i)];
    influence[i] = reading.perReading * reading.sigma;
  }
  return influence;
}

DiagnosisVerdict verdictOf(const Chances& chances, const std::vector<Cause>& causes) {
  if (chances.nothing >= chances.known && chances.nothing >= chances.unknown && causes.empty())
    return DiagnosisVerdict::WithinNoise;
  if (causes.empty()) return DiagnosisVerdict::NotInCatalogue;
  if (causes.size() > 1) return DiagnosisVerdict::SeveralCauses;
  return causes.front().indistinguishableFrom.empty() ? DiagnosisVerdict::SingleCause
                                                      : DiagnosisVerdict::Ambiguous;
}

std::optional<GapShape> shapeOf(const Inquiry& inquiry) {
  for (const Explanation& explanation : inquiry.explanations)
    for (const Part& part : explanation.parts)
      if (isShape(inquiry, part)) {
        const Component& shape = inquiry.candidates[part.component];
        return GapShape{shape.id,
                        signature(shape, part.weights).squaredNorm() / inquiry.leftover.chiSquare()};
      }
  return std::nullopt;
}

std::vector<double> inSigma(const GapModel& model) {
  std::vector<double> list;
  for (const AdjustedReading& reading : model.fit.readings) list.push_back(reading.residual / reading.sigma);
  return list;
}

}  // namespace

std::string_view nameOf(DiagnosisVerdict verdict) {
  switch (verdict) {
    case DiagnosisVerdict::WithinNoise:
      return "within-noise";
    case DiagnosisVerdict::SingleCause:
      return "single-cause";
    case DiagnosisVerdict::Ambiguous:
      return "ambiguous";
    case DiagnosisVerdict::SeveralCauses:
      return "several-causes";
    case DiagnosisVerdict::NotInCatalogue:
      return "not-in-catalogue";
  }
  return "";
}

const std::vector<std::string>& diagnosableEffects() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> list;
    for (const Effect& effect : effectCatalogue()) list.emplace_back(effect.id);
    for (const char* id : {jumpId, misreadingId, noiseId}) list.emplace_back(id);
    return list;
  }();
  return ids;
}

Result<Diagnosis> diagnose(const Measurement& measurement, const DiagnosisOptions& options) {
  for (const std::string& id : options.without)
    if (std::ranges::find(diagnosableEffects(), id) == diagnosableEffects().end())
      return Problem{"there is no effect “" + id + "” in the catalogue"};
  Result<GapModel> model = modelOf(measurement);
  if (!model) return model.problem();
  const GapModel original = *model;
  Inquiry inquiry = inquire(*std::move(model), options);
  std::vector<BlamedReading> farOffReadings;
  for (int round = 0; round < 4; ++round) {
    const std::vector<ReadingRef> found = farOff(inquiry);
    if (found.empty()) break;
    for (const Part& part : inquiry.explanations.front().parts) {
      if (part.component < inquiry.candidates.size()) continue;
      const ReadingRef ref = readingOf(inquiry.leftover, part.component, inquiry.candidates.size());
      if (std::ranges::find(found, ref) != found.end())
        farOffReadings.push_back(
            blamed(original, ref, part.weights[0] * sigmaArcseconds(measurement, ref.kind)));
    }
    GapModel next = inquiry.base;
    next.options.without.insert(next.options.without.end(), found.begin(), found.end());
    next.fit = fitJointly(next.measurement, next.starts, next.options);
    inquiry = inquire(std::move(next), options);
  }

  Diagnosis diagnosis;
  const Chances chances = chancesOf(inquiry);
  const bool unknown = chances.unknown > chances.known && chances.unknown > chances.nothing;
  const bool nothing = chances.nothing >= chances.known && !unknown;
  Explanation explanation;
  if (!nothing && !unknown) explanation = bestKnown(inquiry);
  const GapModel after = explanation.parts.empty() && !explanation.noisy
                             ? inquiry.base
                             : modelWith(inquiry.base, explanation, inquiry.candidates, inquiry.leftover);
  if (!unknown) diagnosis.causes = causesOf(inquiry, explanation, after, farOffReadings);
  diagnosis.verdict = unknown ? DiagnosisVerdict::NotInCatalogue : verdictOf(chances, diagnosis.causes);
  diagnosis.gap = sizeOf(original);
  diagnosis.after = sizeOf(after);
  diagnosis.shrink.inSample = diagnosis.gap.rms > 0 ? 1 - diagnosis.after.rms / diagnosis.gap.rms : 0;
  const double excess = excessOf(original);
  diagnosis.shrink.ofExcess = excess > 0 ? std::clamp(1 - excessOf(after) / excess, 0.0, 1.0) : 0;
  if (!explanation.parts.empty())
    diagnosis.shrink.heldOut = heldOutShrinkage(inquiry.leftover, explanation, inquiry.candidates);
  diagnosis.candidates = candidatesOf(inquiry);
  diagnosis.where = sharesOfFrames(inquiry.leftover, inquiry.candidates, inquiry.explanations);
  std::ranges::move(sharesOfReadings(inquiry.leftover, inquiry.base.measurement, inquiry.base.fit),
                    std::back_inserter(diagnosis.where));
  diagnosis.steps = stepsOf(inquiry, explanation);
  diagnosis.before = estimateOf(original);
  diagnosis.afterwards = afterwardsOf(inquiry, explanation, after);
  diagnosis.unseen =
      unseenEffects(inquiry.leftover, inquiry.candidates, inquiry.base.measurement, perSigma(inquiry.base));
  if (unknown) diagnosis.shape = shapeOf(inquiry);
  diagnosis.leftBefore = inSigma(original);
  diagnosis.leftAfter = inSigma(after);
  for (const AdjustedReading& reading : original.fit.readings)
    diagnosis.readings.push_back(blamed(original, {reading.arc, reading.sighting, reading.kind},
                                        Angle::fromRadians(reading.residual).arcseconds()));
  diagnosis.advice = adviceFor(inquiry.base, diagnosis);
  diagnosis.sentence = sentenceFor(diagnosis);
  return diagnosis;
}

}  // namespace alidade
