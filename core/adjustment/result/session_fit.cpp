#include "core/adjustment/result/session_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/adjustment/arc/first_fit.h"
#include "core/adjustment/result/session_findings.h"
#include "core/adjustment/result/setup_findings.h"
#include "core/base/threads.h"
#include "core/effects/catalogue.h"

namespace alidade {

namespace {

FitFinding missing(const ArcMeasurement& arc, const ArcFault& why) {
  const auto* few = std::get_if<arc_fault::TooFewPlaces>(&why);
  const bool isToCome = few && few->places == 0;
  return {isToCome ? Severity::Note : Severity::Error,
          Place{.position = arc.position, .reading = {}, .field = "readings"},
          session_finding::ArcMissing{arc.axisDeg, why, arc.repeat}};
}

/// The effects of the model whose ids are known, each once.
std::vector<const Effect*> knownEffects(const Measurement& measurement) {
  std::vector<const Effect*> effects;
  for (const std::string& id : measurement.effects) {
    const Effect* effect = effectById(id, measurement);
    if (effect && std::ranges::find(effects, effect) == effects.end()) effects.push_back(effect);
  }
  return effects;
}

std::vector<EstimatedTerm> termsOf(const std::vector<const Effect*>& effects) {
  std::vector<EstimatedTerm> terms;
  for (const Effect* effect : effects)
    for (const EffectParameter& parameter : effect->parameters)
      terms.push_back({parameter.term, plausibleSize(parameter)});
  return terms;
}

/// Copies circle, residuals and misfit of every arc from the joint adjustment; `scale`: s0.
void takeOver(std::vector<ArcFit>& arcs, const JointFit& joint, double scale) {
  std::vector<double> squares(arcs.size());
  for (const AdjustedReading& reading : joint.readings) {
    SightingResidual& residual = arcs[reading.arc].residuals[reading.sighting];
    residual.arcAngle = joint.arcAngles[reading.arc][reading.sighting];
    if (reading.kind == ReadingKind::Slider) continue;
    const Angle left = Angle::fromRadians(reading.residual);
    const bool isHorizontal = reading.kind == ReadingKind::Horizontal;
    (isHorizontal ? residual.horizontal : residual.vertical) = left;
    (isHorizontal ? residual.horizontalStandardised : residual.verticalStandardised) =
        reading.standardised(scale);
    squares[reading.arc] += left.arcseconds() * left.arcseconds();
  }
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    ArcFit& arc = arcs[i];
    arc.circle = joint.circleOf(i);
    const auto kinds = {Unknown::Kind::CentreX, Unknown::Kind::CentreY, Unknown::Kind::Radius};
    for (const auto row : kinds)
      for (const auto column : kinds)
        arc.cofactor[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
            joint.cofactor(joint.indexOf({.kind = row, .arc = i}), joint.indexOf({.kind = column, .arc = i}));
    arc.chiSquare = joint.residualSums[i].chiSquare;
    arc.degreesOfFreedom = joint.residualSums[i].degreesOfFreedom;
    arc.residualRms = std::sqrt(squares[i] / static_cast<double>(2 * arc.residuals.size()));
    arc.iterations = joint.iterations;
    arc.status = joint.status;
  }
}

std::vector<EffectEstimate> estimatesOf(const JointFit& joint, const std::vector<const Effect*>& effects,
                                        double scale) {
  std::vector<EffectEstimate> estimates;
  for (const Effect* effect : effects) {
    for (const EffectParameter& parameter : effect->parameters) {
      const std::size_t i = joint.indexOf(parameter.term);
      std::vector<double> weights(joint.unknowns.size());
      weights[i] = 1;
      const double factor = modelUnitsPer(parameter.unit);
      estimates.push_back({std::string(effect->id), std::string(parameter.name), std::string(parameter.unit),
                           joint.values[i] / factor, combined(budgetOf(joint, weights, scale)) / factor});
    }
  }
  return estimates;
}

/// Fits each arc alone, in parallel if they are long.
std::vector<Result<ArcFit, ArcFault>> firstFits(const Measurement& measurement) {
  std::vector<Result<ArcFit, ArcFault>> fits(measurement.arcs.size(), ArcFault{});
  doEach(threadsFor(measurement.rows), fits.size(),
         [&](std::size_t i) { fits[i] = firstFit(measurement, measurement.arcs[i]); });
  return fits;
}

/// Adjusts all arcs together. Returns false if the readings do not determine them together.
bool adjust(SessionFit& fit, const Measurement& fitted) {
  std::vector<Circle> starts;
  for (const ArcFit& arc : fit.arcs) starts.push_back(arc.circle);
  const std::vector<const Effect*> effects = knownEffects(fitted);
  fit.joint = fitJointly(fitted, starts, {.terms = termsOf(effects)});
  if (!fit.joint.isDetermined()) return false;
  fit.noise = noiseScale(fit.joint);
  takeOver(fit.arcs, fit.joint, fit.noise.factor);
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    fit.budgets.push_back(arcBudget(fit.joint, i, fit.noise.factor));
    fit.sigmas.push_back(arcSigma(fit.joint, i, fit.noise.factor, fit.budgets.back()));
  }
  fit.intersection = intersect(fitted, fit.joint, fit.noise);
  fit.effects = estimatesOf(fit.joint, effects, fit.noise.factor);
  return true;
}

/// Adds the findings of each arc in order.
void addArcFindings(SessionFit& fit, const Measurement& fitted) {
  std::vector<std::vector<FitFinding>> findings(fit.arcs.size());
  doEach(threadsFor(fitted.rows), findings.size(),
         [&](std::size_t i) { findings[i] = arcFindings(fitted, fitted.arcs[i], fit.arcs[i]); });
  for (std::vector<FitFinding>& ofArc : findings) std::ranges::move(ofArc, std::back_inserter(fit.findings));
}

void judge(SessionFit& fit, const Measurement& measurement) {
  if (!fit.intersection || !measurement.tolerance) return;
  fit.verdict = fit.lengthsInDoubt
                    ? Verdict::Undecided
                    : decide(fit.intersection->value, fit.intersection->expanded, *measurement.tolerance);
}

}  // namespace

const ArcFit* SessionFit::arcAt(int axisDeg) const {
  const auto found = std::ranges::find(arcs, axisDeg, &ArcFit::axisDeg);
  return found == arcs.end() ? nullptr : &*found;
}

const ArcFit* SessionFit::arcOfPosition(std::size_t position) const {
  const auto found = std::ranges::find(arcs, position, &ArcFit::position);
  return found == arcs.end() ? nullptr : &*found;
}

SessionFit fitSession(const Measurement& measurement) {
  SessionFit fit;
  std::vector<Result<ArcFit, ArcFault>> firsts = firstFits(measurement);
  for (std::size_t i = 0; i < firsts.size(); ++i)
    if (firsts[i])
      fit.arcs.push_back(*std::move(firsts[i]));
    else
      fit.findings.push_back(missing(measurement.arcs[i], firsts[i].problem()));
  std::optional<Measurement> part;  // copies the rows only if arcs are left out
  const auto fitted = [&]() -> const Measurement& {
    if (!part && fit.arcs.size() < measurement.arcs.size()) part = fittedPart(measurement, fit);
    return part ? *part : measurement;
  };
  fit.lengthsInDoubt = doubtfulLengths(measurement, fit.arcs);  // every radius is still free
  if (!fit.arcs.empty() && !adjust(fit, fitted())) {
    fit.findings.push_back(
        {Severity::Error, {}, session_finding::Undetermined{!knownEffects(measurement).empty()}});
    fit.arcs.clear();
    fit.joint = {};
    part.reset();
  }
  judge(fit, measurement);
  addArcFindings(fit, fitted());
  std::ranges::move(setupFindings(fitted(), fit), std::back_inserter(fit.findings));
  std::ranges::move(sessionFindings(measurement, fit), std::back_inserter(fit.findings));
  return fit;
}

Measurement fittedPart(const Measurement& measurement, const SessionFit& fit) {
  Measurement part = measurement;
  std::erase_if(part.arcs, [&](const ArcMeasurement& arc) { return !fit.arcOfPosition(arc.position); });
  return part;
}

std::vector<EstimatedTerm> estimatedTerms(const Measurement& measurement) {
  return termsOf(knownEffects(measurement));
}

namespace {

/// The mean of the centres of the arcs at one axis, each fitted alone.
struct PublishedCentre {
  PlanePoint<double> centre;
  AsPrinted asPrinted;
};

std::optional<PublishedCentre> meanAt(const std::vector<PublishedFit>& arcs, int axisDeg) {
  PublishedCentre mean{};
  double count = 0;
  for (const PublishedFit& fit : arcs) {
    if (fit.arc.axisDeg != axisDeg) continue;
    ++count;
    mean.centre.x += (fit.arc.circle.x - mean.centre.x) / count;
    mean.centre.y += (fit.arc.circle.y - mean.centre.y) / count;
    mean.asPrinted.y += (fit.asPrinted.y - mean.asPrinted.y) / count;
  }
  return count > 0 ? std::optional(mean) : std::nullopt;
}

}  // namespace

PublishedSessionFit fitSessionAsPublished(const Measurement& measurement) {
  PublishedSessionFit fit;
  std::vector<Result<PublishedFit, ArcFault>> fitted(measurement.arcs.size(), ArcFault{});
  doEach(threadsFor(measurement.rows), fitted.size(),
         [&](std::size_t i) { fitted[i] = fitArcAsPublished(measurement, measurement.arcs[i]); });
  for (std::size_t i = 0; i < fitted.size(); ++i)
    if (fitted[i])
      fit.arcs.push_back(*std::move(fitted[i]));
    else
      fit.findings.push_back(missing(measurement.arcs[i], fitted[i].problem()));
  std::ranges::move(missingPositions(measurement), std::back_inserter(fit.findings));
  const auto upper = meanAt(fit.arcs, 0), lower = meanAt(fit.arcs, 180);
  if (!upper || !lower) return fit;
  fit.intersection = (upper->centre.y - lower->centre.y) / 2;
  fit.intersectionAsPrinted = (upper->asPrinted.y - lower->asPrinted.y) / 2;
  fit.inPlane = std::hypot(upper->centre.x - lower->centre.x, *fit.intersection * 2) / 2;
  return fit;
}

}  // namespace alidade
