#include "core/guidance/outlook.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/adjustment/result/expected_reading.h"
#include "core/adjustment/result/intersection.h"
#include "core/base/square.h"
#include "core/base/statistics.h"
#include "core/diagnosis/planned_uncertainty.h"
#include "core/guidance/forecast.h"
#include "core/observation/half_turn.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

/// The fitted arc of a position, else of another one, else the nominal arc.
Circle circleOf(const Measurement& measurement, const SessionFit& fit, const ArcMeasurement& arc) {
  if (const ArcFit* own = fit.arcOfPosition(arc.position)) return own->circle;
  if (!fit.arcs.empty()) return fit.arcs.front().circle;
  return {0, 0, measurement.nominalRadius};
}

/// Places the sightings of one of `plan`'s arcs on the fitted circle, with readings free of errors. The
/// slider is at rest during a visit, so all sightings of the visit are at the place of the first.
void placeOnArc(ArcMeasurement& arc, const Measurement& plan, const SessionFit& fit, bool readsSlider) {
  const Circle circle = circleOf(plan, fit, arc);
  const ZeroLine line(plan, arc);
  std::map<std::pair<int, int>, double> places;  // arc angles, by point and round
  for (Sighting& sighting : arc.sightings) {
    const double phi = places
                           .emplace(std::pair(sighting.point, sighting.round),
                                    nearestArcAngle(circle, line.sightedPoint(sighting)))
                           .first->second;
    sightPerfectly(sighting, line, circle, phi);
    if (readsSlider || sighting.slider)
      sighting.slider = Angle::fromRadians(sliderCoordinateOf(phi, arc.axisDeg));
  }
}

std::vector<SightedZero> sightingsOf(const ProtocolZeros& planned) {
  std::vector<SightedZero> zeros;
  for (const int face : planned.before) zeros.push_back({face, false, {}, {}});
  for (const int face : planned.after) zeros.push_back({face, true, {}, {}});
  return zeros;
}

ZeroSightings zerosOf(const ProtocolZeros& planned) {
  const auto countOf = [&](int face) {
    return std::ranges::count(planned.before, face) + std::ranges::count(planned.after, face);
  };
  const int faces = countOf(2) > 0 ? 2 : 1;
  ZeroSightings zeros;
  zeros.count = static_cast<int>(planned.before.size() + planned.after.size());
  zeros.isInBothFaces = faces == 2;
  zeros.factor = 0;
  for (int face = 1; face <= faces; ++face) {
    zeros.factor += 1.0 / static_cast<double>(countOf(face));
  }
  zeros.factor = std::sqrt(zeros.factor) / faces;
  return zeros;
}

/// One more round for a position: in the opposite direction to its last one, with the faces of the protocol's
/// rounds in turn.
std::vector<PlannedSighting> furtherRound(const SightingProtocol& protocol, std::size_t position,
                                          int further) {
  SightingProtocol alone = protocol;
  alone.positions = {protocol.positions[position]};
  auto& rounds = alone.positions.front().rounds;
  const std::size_t count = rounds.size(), which = static_cast<std::size_t>(further - 1) % count;
  const bool isBack = (further % 2 == 1) != rounds.back().isBack;
  rounds = {rounds[which]};
  rounds.front().isBack = isBack;
  std::vector<PlannedSighting> sightings = sightingsInOrder(alone);
  std::erase_if(sightings, &PlannedSighting::isZero);
  for (PlannedSighting& sighting : sightings) {
    sighting.protocolPosition = position;
    sighting.round = static_cast<int>(count) + further;
  }
  return sightings;
}

/// Calculates U of planned measurements.
class Expectation {
 public:
  /// `fit` is that of the existing readings, `diagnosis` its diagnosis or null.
  Expectation(const SessionFit& fit, const Diagnosis* diagnosis)
      : m_scatter(fit.arcs.empty() ? NoiseScale{1, DegreesOfFreedom::infinite().count()} : fit.noise),
        m_noise(diagnosis ? diagnosis->noise : std::max(1.0, m_scatter.factor)) {}

  /// U of the existing readings becomes `stated`, and U of further readings changes in proportion. If the
  /// stated U, measured, is larger than the planned one, the difference of the squares stays constant.
  void startFrom(ExpandedPair planned, const ExpandedPair& stated) {
    if (planned.ofFit > 0) m_ofFit = stated.ofFit / planned.ofFit;
    if (!planned.asMeasured || !stated.asMeasured) return;
    if (*stated.asMeasured < *planned.asMeasured)
      m_asMeasured = *stated.asMeasured / *planned.asMeasured;
    else
      m_inQuadrature = std::sqrt(square(*stated.asMeasured) - square(*planned.asMeasured));
  }

  std::optional<ExpandedPair> of(const Measurement& plan) const {
    const auto ofFit = plannedUncertaintyOfFit(plan, m_scatter);
    if (!ofFit) return std::nullopt;
    ExpandedPair pair{m_ofFit * *ofFit};
    if (const auto measured = plannedUncertainty(plan, m_noise))
      pair.asMeasured = std::hypot(m_asMeasured * *measured, m_inQuadrature);
    return pair;
  }

  /// Ratio of noise to stated noise, at least 1: no verdict relies on scatter below the stated noise.
  double noise() const { return m_noise; }

 private:
  NoiseScale m_scatter;  ///< of the fit, which takes effects for noise
  double m_noise;
  double m_ofFit = 1, m_asMeasured = 1;  ///< ratio of U, stated over planned
  double m_inQuadrature = 0;             ///< part of U, measured, that is added in quadrature, mm
};

/// Further rounds that are always considered: effects of time average out over both directions.
constexpr int thereAndBack = 2;

/// The largest number of further rounds that is considered.
constexpr int mostRounds = 8;

/// Factor that reduces the noise to show the remaining U. With a smaller factor, the sizes of undetectable
/// effects differ too much from the others for a fit.
constexpr double lessNoise = 0.1;

/// The plan with less noise of circles and slider; the zeros keep their σ.
Measurement withLessNoise(Measurement plan) {
  plan.sigmaHorizontal = plan.sigmaHorizontal * lessNoise;
  plan.sigmaVertical = plan.sigmaVertical * lessNoise;
  plan.sigmaSlider = plan.sigmaSlider * lessNoise;
  plan.zerosAreReadings = false;
  return plan;
}

/// U without noise, from U with full and with reduced noise: U² is a constant plus a multiple of σ² of the
/// noise.
double withoutNoise(double all, double less) {
  const double share = square(lessNoise);
  return std::sqrt(std::max(square(less) - share * square(all), 0.0) / (1 - share));
}

std::optional<ExpandedPair> withoutNoise(const ExpandedPair& all, const std::optional<ExpandedPair>& less) {
  if (!less) return std::nullopt;
  ExpandedPair none{withoutNoise(all.ofFit, less->ofFit)};
  if (all.asMeasured && less->asMeasured) none.asMeasured = withoutNoise(*all.asMeasured, *less->asMeasured);
  return none;
}

/// The rows of `measurement` around the fitted radius: a known radius that contradicts the readings would be
/// noise in a plan.
Measurement withFittedRadius(Measurement measurement, const SessionFit& fit) {
  if (!fit.arcs.empty()) measurement.nominalRadius = fit.arcs.front().circle.radius;
  return measurement;
}

/// The existing rows, with readings free of errors.
Measurement asThere(const Measurement& measurement, const SessionFit& fit) {
  Measurement plan = withFittedRadius(measurement, fit);
  for (ArcMeasurement& arc : plan.arcs) placeOnArc(arc, plan, fit, false);
  return plan;
}

void seeVerdict(Outlook& outlook, const Measurement& measurement, const SessionFit& fit,
                const Diagnosis* diagnosis) {
  if (!measurement.tolerance || measurement.measurand != Measurand::Intersection || !fit.intersection) return;
  const double tolerance = *measurement.tolerance;
  const double modelled = std::abs(fit.intersection->value);
  const double found =
      diagnosis && diagnosis->measured ? std::abs(diagnosis->measured->estimate.value) : modelled;
  outlook.isWithin = modelled <= tolerance;
  outlook.isTorn = outlook.isWithin != (found <= tolerance);
  outlook.needed = ExpandedPair{std::abs(tolerance - modelled), std::abs(tolerance - found)};
}

}  // namespace

bool Outlook::isEnough(const ExpandedPair& expanded) const {
  if (!needed || isTorn) return false;
  const auto suffices = [this](double own, double most) { return isWithin ? own <= most : own < most; };
  return suffices(expanded.ofFit, needed->ofFit) &&
         (!expanded.asMeasured || suffices(*expanded.asMeasured, *needed->asMeasured));
}

std::optional<int> Outlook::roundsNeeded() const {
  const auto enough =
      std::ranges::find_if(ahead, [this](const RoundsAhead& one) { return isEnough(one.expanded); });
  return enough == ahead.end() ? std::nullopt : std::optional(enough->rounds);
}

std::optional<Measurement> carriedOut(const Measurement& measurement, const SessionFit& fit,
                                      const SightingProtocol& protocol, const ProtocolProgress& progress,
                                      int rounds) {
  auto arcs = arcsOf(withFittedRadius(measurement, fit), protocol, progress);
  if (!arcs) return std::nullopt;
  Measurement& plan = arcs->measurement;
  std::vector<PlannedSighting> planned;
  for (const FollowedSighting& followed : progress.sightings)
    if (!followed.planned.isZero && followed.state != SightingState::Taken &&
        followed.state != SightingState::Excluded)
      planned.push_back(followed.planned);
  for (std::size_t p = 0; p < protocol.positions.size(); ++p)
    for (int further = 1; further <= rounds; ++further)
      for (const PlannedSighting& sighting : furtherRound(protocol, p, further)) planned.push_back(sighting);

  std::vector<SightingToCome> toCome;
  for (const PlannedSighting& one : planned)  // readings in face 1; face 2 differs by its face only
    toCome.push_back({arcs->positions[one.protocolPosition], one.point, one.round, 1});
  const auto expected = expectedReadings(plan, fit, toCome, nominalPlaces(protocol, arcs->positions));
  const double down = plan.verticalCircle == VerticalCircle::Zenith ? 1 : -1;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    if (!expected[i]) continue;
    ArcMeasurement& arc = *std::ranges::find(plan.arcs, toCome[i].position, &ArcMeasurement::position);
    arc.sightings.push_back({.row = arc.sightings.size(),
                             .point = planned[i].point,
                             .round = planned[i].round,
                             .face = planned[i].face,
                             .a = wrapped(expected[i]->horizontal - arc.zeroHorizontal),
                             .e = wrapped((arc.zeroVertical - expected[i]->vertical) * down),
                             .slider = {}});
  }
  plan.rows = 0;
  for (ArcMeasurement& arc : plan.arcs) {
    std::set<std::tuple<int, int, int>> there;  // existing sightings come first; duplicates are removed
    std::erase_if(arc.sightings, [&](const Sighting& sighting) {
      return !there.emplace(sighting.point, sighting.round, sighting.face).second;
    });
    const auto p = std::ranges::find(arcs->positions, arc.position) - arcs->positions.begin();
    const bool isPlanned = p < std::ssize(arcs->positions);
    if (isPlanned) {
      const ProtocolZeros& zeros = protocol.positions[static_cast<std::size_t>(p)].zeros;
      arc.zero = zerosOf(zeros);
      arc.zeroSightings = sightingsOf(zeros);
    }
    placeOnArc(arc, plan, fit, isPlanned && protocol.readsSlider);
    for (Sighting& sighting : arc.sightings) {
      sighting.sequence = plan.rows++;
      sighting.minutes.reset();
    }
  }
  std::erase_if(plan.arcs, [](const ArcMeasurement& arc) { return arc.sightings.empty(); });
  setMoments(plan);
  return std::move(plan);
}

Outlook outlookOf(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                  const SightingProtocol& protocol, const ProtocolProgress& progress,
                  const std::stop_token& stop) {
  Outlook outlook;
  seeVerdict(outlook, measurement, fit, diagnosis);
  Expectation expectation(fit, diagnosis);
  if (fit.intersection) outlook.now = expectation.of(asThere(measurement, fit));
  if (outlook.now) {
    ExpandedPair stated{fit.intersection->expanded, outlook.now->asMeasured};
    if (diagnosis && diagnosis->measured) stated.asMeasured = diagnosis->measured->estimate.expanded;
    expectation.startFrom(*outlook.now, stated);
    outlook.now = stated;
  }
  const auto planOf = [&](int rounds) { return carriedOut(measurement, fit, protocol, progress, rounds); };
  const std::optional<Measurement> plan = planOf(0);
  if (!plan || stop.stop_requested()) return outlook;
  outlook.whole = effortOf(*plan, protocol.minutes);
  std::optional<Measurement> ahead = plan;
  const auto addAhead = [&](int rounds) {
    if (rounds > 0) ahead = planOf(rounds);
    const auto expanded = ahead ? expectation.of(*ahead) : std::nullopt;
    if (expanded) outlook.ahead.push_back({rounds, *expanded});
    return expanded && !stop.stop_requested();
  };
  int rounds = 0;
  for (; rounds <= thereAndBack; ++rounds)
    if (!addAhead(rounds)) return outlook;
  outlook.limit = withoutNoise(outlook.ahead.back().expanded, expectation.of(withLessNoise(*ahead)));
  const bool isWithinReach = outlook.limit && outlook.isEnough(*outlook.limit);
  for (; outlook.needed && isWithinReach && rounds <= mostRounds && !outlook.roundsNeeded(); ++rounds)
    if (!addAhead(rounds)) return outlook;
  if (outlook.needed && !outlook.roundsNeeded() && !stop.stop_requested())
    outlook.instead = plannedUncertainties(*plan, expectation.noise());
  return outlook;
}

}  // namespace alidade
