#include "core/diagnosis/search/inquiry.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/adjustment/gross_errors/gross_error_search.h"
#include "core/adjustment/joint/sighted_zeros.h"
#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/candidates/gross_error_components.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/candidates/shape_components.h"
#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/explained_model.h"
#include "core/diagnosis/search/pause.h"
#include "core/effects/cause_ids.h"
#include "core/effects/known_sizes.h"
#include "core/observation/half_turn.h"
#include "core/session/zero_mean.h"

namespace alidade {

namespace {

bool considered(const DiagnosisOptions& options, std::string_view id) {
  return std::ranges::find(options.without, id) == options.without.end();
}

/// Prior odds that the zeros sight different marks. They apply if the session does not state a common mark
/// and the zeros differ too much for one (`areZerosInDoubt`).
constexpr double doubtfulZeros = 1;

/// Prior odds of a rare effect relative to those of other effects.
constexpr double seldom = 0.4;

/// Whether an effect is rare in practice. Axial play of a bearing is more frequent than a skew guideway. An
/// axis out of plumb is more frequent than a bending arm or air layers. An eccentric circle is more frequent
/// than graduation errors.
bool isMetSeldom(const Effect& effect) {
  using enum ErrorTerm;
  constexpr ErrorTerm seldomMet[] = {PlaneSkew, ArmSag, VerticalGraduationSine, VerticalRefraction};
  return std::ranges::find(seldomMet, effect.parameters.front().term) != std::ranges::end(seldomMet);
}

Candidates candidatesFor(const GapModel& base, const Leftover& leftover, const DiagnosisOptions& options,
                         const PriorOdds& odds) {
  std::vector<std::string> leftOut = options.without;
  for (const std::string& id : base.measurement->effects) {
    const Effect* effect = effectById(id, *base.measurement);
    if (!effect || !knownOf(*base.measurement, *effect)) leftOut.push_back(id);
  }
  Candidates candidates;
  const auto addSharing = [&](double all, auto components, Offer offer = {}) {
    const double each = all / static_cast<double>(std::max<std::size_t>(components.size(), 1));
    candidates.add(std::move(components), each, offer);
  };
  std::vector<EffectComponent> usual, rare, known;
  for (EffectComponent& effect : effectsBeyond(base, leftover, leftOut))
    (effect.isKnown() ? known : isMetSeldom(effect.effect()) ? rare : usual).push_back(std::move(effect));
  candidates.add(std::move(usual), odds.effect);
  candidates.add(std::move(rare), odds.effect * seldom);
  for (EffectComponent& effect : known) {
    const double stale = staleChanceOf(*base.measurement, effect.effect());
    candidates.add(std::vector{std::move(effect)}, odds.effect * stale);
  }
  if (considered(options, jumpId)) {
    addSharing(odds.jump, jumpComponents(leftover), {.offered = 2, .oneAtMost = true});
    addSharing(areZerosInDoubt(*base.measurement) ? doubtfulZeros : odds.wrongZero, wrongZeros(leftover),
               {.offered = 2, .oneAtMost = true});
  }
  addSharing(odds.shape, shapeComponents(leftover, *base.measurement, *base.fit, options.without));
  if (considered(options, grossErrorId))
    addSharing(odds.grossError, grossErrorComponents(leftover, *base.measurement), {.offered = 4});
  return candidates;
}

Inquiry searched(GapModel own, GapModel expected, GapModel base, Leftover leftover,
                 const DiagnosisOptions& options, const std::stop_token& stop) {
  SearchOptions search;
  search.noise = considered(options, noiseId);
  search.stop = stop;
  Candidates candidates;
  if (!stop.stop_requested()) candidates = candidatesFor(base, leftover, options, search.odds);
  std::vector<Explanation> explanations = explain(leftover, candidates, search);
  return {std::move(own),
          std::move(expected),
          std::move(base),
          std::move(leftover),
          std::move(candidates),
          std::move(explanations),
          {},
          {}};
}

/// Adds the reference as an observation of Δd, if it is known and requested.
Linearised withReference(Linearised equations, const GapModel& base, const DiagnosisOptions& options) {
  const Measurement& measurement = *base.measurement;
  const auto upper = arcAt(measurement, 0), lower = arcAt(measurement, 180);
  if (!options.withReference || !measurement.sigmaReference || !upper || !lower) return equations;
  Condition condition{std::vector<double>(equations.unknowns.size()), *measurement.referenceIntersection};
  for (const auto& [arc, axisDeg] : {std::pair(*upper, 0), std::pair(*lower, 180)}) {
    const Unknown height{.kind = Unknown::Kind::CentreY, .arc = arc};
    const auto index = std::ranges::find(equations.unknowns, height) - equations.unknowns.begin();
    const double per = intersectionPerHeight(axisDeg);
    condition.derivatives[static_cast<std::size_t>(index)] = per / *measurement.sigmaReference;
    condition.residual -= per * base.fit->values[base.fit->indexOf(height)];
  }
  condition.residual /= *measurement.sigmaReference;
  equations.conditions.push_back(std::move(condition));
  return equations;
}

/// Returns the most likely causes without patterns, if one of them is very large. The equations were then
/// linearised far from the solution, at a fit without these causes.
std::optional<Explanation> largeCauses(const Inquiry& inquiry) {
  constexpr double large = 100;  // length of the trace, σ
  Explanation causes = inquiry.explanations.front();
  std::erase_if(causes.parts, [&](const Part& part) { return inquiry.of(part).isShape(); });
  const auto isLarge = [&](const Part& part) {
    const Component& component = inquiry.of(part);
    return !component.grossErrorAt() && component.signatureSquare(part.weights) > large * large;
  };
  if (std::ranges::none_of(causes.parts, isLarge)) return std::nullopt;
  causes.shaped = causes.noisy = false;
  return causes;
}

/// Returns the equations linearised at a fit with added causes, and adds the contribution of these causes to
/// the residuals.
Linearised around(const GapModel& base, const GapModel& withCauses) {
  // A jump is independent of the point of linearisation, and a bent effect has its second derivatives.
  const auto staysOut = [&](ErrorTerm term) {
    const Effect* effect = effectOf(term, *base.measurement);
    return isOfJump(term) || (effect && effect->response == Response::Bent);
  };
  const auto at = [](ErrorTerm term) {
    return Unknown{.kind = Unknown::Kind::Error, .arc = 0, .term = term};
  };
  JointFitOptions options = base.options;
  JointFit fit = *withCauses.fit;
  for (const EstimatedTerm& added : withCauses.options.terms) {
    const auto& known = base.options.terms;
    const bool isKnown = std::ranges::find(known, added.term, &EstimatedTerm::term) != known.end();
    if (staysOut(added.term))
      fit.values[fit.indexOf(at(added.term))] =
          isKnown ? base.fit->values[base.fit->indexOf(at(added.term))] : 0;
    else if (!isKnown)
      options.terms.push_back(added);
  }
  Linearised equations = linearise(*base.measurement, fit, options);
  for (std::size_t t = base.options.terms.size(); t < options.terms.size(); ++t) {
    const ErrorTerm term = options.terms[t].term;
    double& value = equations.termValues[static_cast<std::size_t>(term)];
    for (std::size_t i = 0; i < equations.readings.size(); ++i)
      equations.readings[i].residual += equations.ofTerm(i, term) * value;
    value = 0;
  }
  return equations;
}

constexpr double knownNoiseTo = 0.2;  // change of ln noise below which the search is not repeated

/// Returns the scale of the noise if the model is closed and the noise is almost certainly larger than
/// stated; otherwise 1. With a scale above 1, pointing zeros with stated σ get a larger weight.
double knownNoise(const Inquiry& inquiry) {
  const bool isLarger = inquiry.base.options.isClosed && inquiry.explanations.front().noisy &&
                        inquiry.probabilityOf(noiseId) > thresholds.certain;
  return isLarger ? inquiry.explanations.front().noise : 1;
}

Inquiry inquireOnce(GapModel own, const DiagnosisOptions& options, const std::stop_token& stop) {
  constexpr int mostRounds = 3;
  GapModel expected = withKnownSizes(own);
  GapModel base = closedModelOf(expected).value_or(expected);
  Leftover leftover(withReference(linearise(*base.measurement, *base.fit, base.options), base, options),
                    base.options.terms);
  Inquiry inquiry =
      searched(std::move(own), std::move(expected), std::move(base), std::move(leftover), options, stop);
  double noise = 1;
  for (int round = 0; round < mostRounds && !stop.stop_requested(); ++round) {
    if (const double found = knownNoise(inquiry); std::abs(std::log(found / noise)) > knownNoiseTo) {
      noise = found;
      Leftover noisy(inquiry.leftover.equations(), inquiry.base.options.terms, noise);
      inquiry = searched(std::move(inquiry.own), std::move(inquiry.expected), std::move(inquiry.base),
                         std::move(noisy), options, stop);
      continue;
    }
    const std::optional<Explanation> causes = largeCauses(inquiry);
    if (!causes) break;
    const GapModel withCauses = modelWith(inquiry.base, *causes, inquiry.candidates, inquiry.leftover);
    if (!withCauses.fit->converged()) break;
    Leftover closer(withReference(around(inquiry.base, withCauses), withCauses, options),
                    inquiry.base.options.terms, noise);
    const std::vector<Part> before = inquiry.explanations.front().parts;
    inquiry = searched(std::move(inquiry.own), std::move(inquiry.expected), std::move(inquiry.base),
                       std::move(closer), options, stop);
    if (std::ranges::all_of(
            before, [&](const Part& part) { return inquiry.explanations.front().has(part.component); }))
      break;
  }
  if (inquiry.own.measurement->pauseRows > 0 || stop.stop_requested()) return inquiry;
  const double pause = likeliestPause(inquiry).value_or(0);
  if (pause == 0) return inquiry;
  Measurement paused = *inquiry.own.measurement;
  paused.pauseRows = pause;
  setMoments(paused);
  GapModel withPause = inquiry.own;
  withPause.measurement = std::make_shared<const Measurement>(std::move(paused));
  return inquireOnce(std::move(withPause), options, stop);
}

/// Returns gross errors so large that they spoil the fit at which the equations were linearised, and certain
/// ones in sightings of zeros.
std::vector<ExcludedReading> toExclude(const Inquiry& inquiry) {
  constexpr double largeSigma = 300;
  const auto isCertain = [&](const Part& part) {
    return inquiry.chanceOf([&](const Explanation& other) { return other.has(part.component); }) >=
           thresholds.certain;
  };
  std::vector<ExcludedReading> found;
  for (const Part& part : inquiry.explanations.front().parts)
    if (const auto reading = inquiry.of(part).grossErrorAt();
        reading && (inquiry.leftover.reading(*reading).isZero ? isCertain(part)
                                                              : std::abs(part.weights[0]) > largeSigma))
      found.push_back({readingRef(inquiry.leftover, *reading), part.weights[0],
                       deviationAt(inquiry, *reading, part.weights[0])});
  return found;
}

/// Takes readings out of the session's model. A zero is then the mean of its other sightings.
void exclude(GapModel& own, const Inquiry& inquiry, const std::vector<ExcludedReading>& found) {
  std::set<std::pair<std::size_t, std::size_t>, std::greater<>> zeros;  // arc and sighting, the last first
  for (const ExcludedReading& far : found)
    if (far.deviation.isZero)
      zeros.emplace(far.reading.arc, far.reading.sighting);
    else
      own.options.without.push_back(far.reading);
  for (const auto& [arc, sighting] : zeros)
    own.measurement = std::make_shared<const Measurement>(withoutZeroSighting(
        *own.measurement, arc, indexOfZero(inquiry.base.measurement->arcs[arc], sighting)));
  own.refit();
}

/// The reading as `Inquiry::ofAll` numbers it: with the sightings of zeros that were excluded before.
ReadingRef inAll(ReadingRef reading, const std::vector<ExcludedReading>& before) {
  const bool isPassed = std::ranges::any_of(before, [&](const ExcludedReading& other) {
    return other.deviation.isZero && other.reading.arc == reading.arc &&
           other.reading.sighting <= reading.sighting;
  });
  if (isPassed) ++reading.sighting;  // two excluded sightings of a zero differ in their face
  return reading;
}

/// Returns one or two readings without which all other readings agree a hundred times better. An error of
/// many degrees spoils the whole fit, and the usual search close to this fit misses the error. The search
/// here begins with a majority of the rows; the model then starts from the circles that it found.
std::vector<ExcludedReading> farOff(GapModel& own, const std::stop_token& stop) {
  constexpr double better = 100;
  constexpr std::size_t most = 2;
  const Measurement& measurement = *own.measurement;
  const double noise = noiseScale(*own.fit).factor;
  if (!(noise > better)) return {};
  const GrossErrorSearch search =
      searchGrossErrors(measurement, {.fit = own.options, .known = own.fit.get()}, stop);
  if (search.grossErrors.size() > most || search.degreesOfFreedom < 1 || search.noiseFactor > noise / better)
    return {};
  for (std::size_t i = 0; i < own.starts.size(); ++i) own.starts[i] = search.fit.circleOf(i);
  std::vector<ExcludedReading> found;
  for (const GrossError& error : search.grossErrors) {
    found.push_back({error.cell, error.size.radians() / statedSigma(measurement, error.cell.kind).radians(),
                     deviationAt(measurement, error.cell, error.size.arcseconds())});
    own.options.without.insert(own.options.without.end(), error.rivals.begin(), error.rivals.end());
  }
  return found;
}

}  // namespace

double Inquiry::chanceOf(const std::function<bool(const Explanation&)>& isIncluded) const {
  double sum = 0;
  for (const Explanation& explanation : explanations)
    if (isIncluded(explanation)) sum += explanation.chance;
  return std::min(sum, 1.0);  // removes rounding errors
}

double Inquiry::probabilityOf(std::string_view id) const {
  return chanceOf([&](const Explanation& explanation) {
    return (id == noiseId && explanation.noisy) ||
           std::ranges::any_of(explanation.parts, [&](const Part& part) { return of(part).id() == id; });
  });
}

Inquiry inquire(GapModel model, const DiagnosisOptions& options, const std::stop_token& stop) {
  constexpr int mostRounds = 4;
  Inquiry inquiry = inquireOnce(std::move(model), options, stop);
  std::shared_ptr<const Inquiry> first;
  for (int round = 0; round < mostRounds; ++round) {
    GapModel next = inquiry.own;
    std::vector<ExcludedReading> found;
    if (round == 0) found = farOff(next, stop);
    if (found.empty()) found = toExclude(inquiry);
    if (found.empty() || stop.stop_requested()) break;
    exclude(next, inquiry, found);
    if (!next.fit->isDetermined()) break;
    std::vector<ExcludedReading> all = inquiry.excluded;
    for (ExcludedReading& far : found) {
      far.reading = inAll(far.reading, inquiry.excluded);
      all.push_back(std::move(far));
    }
    if (!first) first = std::make_shared<const Inquiry>(std::move(inquiry));
    inquiry = inquireOnce(std::move(next), options, stop);
    inquiry.excluded = std::move(all);
    inquiry.before = first;
  }
  return inquiry;
}

std::optional<NoModel> undetermined(const Inquiry& inquiry) {
  if (inquiry.base.fit->isDetermined()) return std::nullopt;
  return NoModel{FitFinding{Severity::Error, {}, session_finding::Undetermined{true}}};
}

ReadingDeviation deviationAt(const Measurement& measurement, const ReadingRef& ref, double size) {
  const ArcMeasurement& arc = measurement.arcs[ref.arc];
  const Sighting& sighting = arc.sightings[ref.sighting];
  return {.position = arc.position,
          .row = sighting.row,
          .axisDeg = arc.axisDeg,
          .round = sighting.round,
          .point = sighting.point,
          .face = sighting.face,
          .repeat = arc.repeat,
          .kind = ref.kind,
          .isZero = sighting.isZero,
          .isAfter = sighting.isZero && arc.zeroSightings[indexOfZero(arc, ref.sighting)].isAfter,
          .size = size};
}

ReadingDeviation deviationAt(const Inquiry& inquiry, Eigen::Index reading, double sigmas) {
  const ReadingRef ref = readingRef(inquiry.leftover, reading);
  const Angle sigma = Angle::fromRadians(inquiry.leftover.reading(reading).sigma);
  return deviationAt(*inquiry.base.measurement, ref, sigmas * sigma.arcseconds());
}

}  // namespace alidade
