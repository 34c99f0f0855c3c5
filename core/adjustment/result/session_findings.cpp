#include "core/adjustment/result/session_findings.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/adjustment/result/closures.h"
#include "core/base/angle_text.h"
#include "core/base/statistics.h"
#include "core/effects/catalogue.h"
#include "core/effects/known_sizes.h"
#include "core/session/compensator.h"

namespace alidade {

using namespace session_finding;

namespace {

Place fieldOf(const char* name) {
  return {.position = {}, .reading = {}, .field = name};
}

bool holdsAxis(const Measurement& measurement, int axisDeg) {
  return std::ranges::any_of(measurement.arcs,
                             [&](const ArcMeasurement& arc) { return arc.axisDeg == axisDeg; });
}

/// Reports a difference between the positions in a quantity that half a turn preserves, if it is too large.
template <typename Finding>
void judgeClosure(std::vector<FitFinding>& findings, const SessionFit& fit, Unknown::Kind quantity) {
  const ArcFit *upper = fit.arcAt(0), *lower = fit.arcAt(180);
  if (!upper || !lower) return;
  const auto index = [&](const ArcFit* arc) { return static_cast<std::size_t>(arc - fit.arcs.data()); };
  const auto misclosure = misclosureOf(fit.joint, quantity, index(upper), index(lower), fit.noise.factor);
  if (!misclosure) return;
  const double difference = std::abs(misclosure->value), sigma = misclosure->sigma;
  constexpr double leastFactor =
      3.29;  // normal quantile, never above the slower quantile of Student's distribution
  if (difference <= leastFactor * sigma) return;
  const double bound = coverageFactor(1 - improbable, fit.noise.degreesOfFreedom) * sigma;
  if (difference <= bound) return;
  findings.push_back({Severity::Warning, {}, Finding{difference, bound}});
}

/// The readings alone also determine a radius. The fitted R is its weighted mean with R0, so R0 − R has the
/// variance σ0² − σ_R² if both are right within their σ.
void judgeKnownRadius(std::vector<FitFinding>& findings, const Measurement& measurement,
                      const SessionFit& fit) {
  if (measurement.radiusModel != RadiusModel::Known || fit.arcs.empty()) return;
  const std::size_t radius = fit.joint.indexOf({.kind = Unknown::Kind::Radius});
  const double prior = fit.joint.priorSigmas[radius];
  std::vector<double> weights(fit.joint.unknowns.size());
  weights[radius] = 1;
  const double variance = fit.joint.cofactor(radius, radius);
  const double ofReadings =
      std::pow(fit.noise.factor, 2) * (variance - variance * variance / (prior * prior));
  const double ofRadius = std::pow(prior - variance / prior, 2);
  double ofConsidered = 0;
  for (const BudgetEntry& entry : budgetOf(fit.joint, weights, fit.noise.factor))
    if (entry.source == UncertaintySource::PointingZeros || entry.source == UncertaintySource::Distance)
      ofConsidered += std::pow(entry.sigma, 2);
  const double away = fit.joint.values[radius] - measurement.nominalRadius;
  const double bound = coverageFactor(1 - improbable, fit.noise.degreesOfFreedom) *
                       std::sqrt(std::max(0.0, ofReadings + ofRadius + ofConsidered));
  if (std::abs(away) <= bound) return;
  findings.push_back({Severity::Warning, fieldOf("geometry.radius_mm"),
                      KnownRadiusContradicted{measurement.nominalRadius, away, bound}});
}

void judgeNominalRadius(std::vector<FitFinding>& findings, const Measurement& measurement,
                        const SessionFit& fit) {
  const std::vector<Closure> closures = closuresOf(measurement, fit.joint);
  const auto closure = std::ranges::find(closures, Closure::Of::NominalRadius, &Closure::of);
  if (closure == closures.end() || !fails(*closure)) return;
  const double bound = coverageFactor(1 - improbable, fit.noise.degreesOfFreedom) * closure->sigma;
  findings.push_back({Severity::Warning, fieldOf("geometry.radius_mm"),
                      NominalRadiusContradicted{measurement.nominalRadius, closure->value, bound}});
}

/// Two runs over an arc never agree in every reading, not even where they are rounded to a second.
void judgeCopies(std::vector<FitFinding>& findings, const Measurement& measurement) {
  const auto isSame = [](const Sighting& one, const Sighting& other) {
    return areEqualAsTyped(one.a, other.a) && areEqualAsTyped(one.e, other.e);
  };
  for (std::size_t later = 0; later < measurement.arcs.size(); ++later)
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const ArcMeasurement &arc = measurement.arcs[later], &other = measurement.arcs[earlier];
      if (arc.axisDeg != other.axisDeg || arc.sightings.size() < 3 ||
          !std::ranges::equal(arc.sightings, other.sightings, isSame))
        continue;
      findings.push_back({Severity::Warning,
                          Place{.position = arc.position, .reading = {}, .field = "readings"},
                          PositionCopied{arc.axisDeg, arc.repeat, other.repeat}});
      break;
    }
}

/// Reports why tilts and corrections of the rows cannot be fully used.
void judgeCompensator(std::vector<FitFinding>& findings, const Measurement& measurement) {
  const CompensatorNotes notes = compensatorKnowledge(measurement).notes;
  const auto add = [&](const char* field, FitFinding::What what) {
    findings.push_back({Severity::Warning, fieldOf(field), std::move(what)});
  };
  if (!notes.mixed.empty())
    add("readings.corrections", CorrectionsDiffer{{notes.mixed.begin(), notes.mixed.end()}});
  if (notes.isInclinationUnknown) add("readings.corrections", TiltsUnused{});
  if (notes.moved) add("readings.tilt_cross_arcsec", AxisMoved{*notes.moved});
  if (notes.index) add("readings.tilt_cross_arcsec", CompensatorOff{*notes.index});
}

}  // namespace

std::vector<FitFinding> missingPositions(const Measurement& measurement) {
  std::vector<FitFinding> findings;
  for (const int axisDeg : {0, 180})
    if (!holdsAxis(measurement, axisDeg))
      findings.push_back({Severity::Warning, {}, PositionMissing{axisDeg}});
  return findings;
}

std::vector<FitFinding> modelFindings(const Measurement& measurement) {
  std::vector<FitFinding> findings;
  for (const std::string& id : measurement.effects)
    if (!effectById(id, measurement))
      findings.push_back({Severity::Warning, fieldOf("model.effects"), UnknownEffect{id}});
  for (const KnownNumber& known : measurement.known)
    if (!findParameter(measurement, known))
      findings.push_back(
          {Severity::Warning, known.where, KnownOfNothing{known.effect, known.parameter, known.unit}});
  judgeCompensator(findings, measurement);
  if (measurement.relation == VerticalAngleRelation::Planar)
    findings.push_back({Severity::Warning, fieldOf("model.vertical_angle"), PlanarRelation{}});
  return findings;
}

std::vector<FitFinding> sessionFindings(const Measurement& measurement, const SessionFit& fit) {
  std::vector<FitFinding> findings = missingPositions(measurement);
  judgeClosure<RadiiDiffer>(findings, fit, Unknown::Kind::Radius);
  judgeClosure<CentresDiffer>(findings, fit, Unknown::Kind::CentreX);
  judgeKnownRadius(findings, measurement, fit);
  judgeNominalRadius(findings, measurement, fit);
  judgeCopies(findings, measurement);
  std::ranges::move(modelFindings(measurement), std::back_inserter(findings));
  return findings;
}

}  // namespace alidade
