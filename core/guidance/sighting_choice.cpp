#include "core/guidance/sighting_choice.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "core/guidance/forecast.h"

namespace alidade {

namespace {

using Index = std::optional<std::size_t>;

/// The sightings left in a protocol, relative to the position of the last reading.
class Remaining {
 public:
  Remaining(const SightingProtocol& protocol, const ProtocolProgress& progress, std::size_t ofLastReading)
      : m_protocol(protocol), m_progress(progress) {
    Index begun;
    for (const FollowedSighting& followed : all()) {
      if (followed.position == ofLastReading) m_here = followed.planned.protocolPosition;
      if (isThere(followed)) begun = followed.planned.protocolPosition;
    }
    if (!m_here || !begun) return;
    m_isTurned = *begun != *m_here;
    if (m_isTurned) m_other = begun;
    for (std::size_t p = 0; p < protocol.positions.size() && !m_other; ++p)
      if (isOtherAxis(p) && !isBegun(p)) m_other = p;
    if (m_isTurned && !isOtherAxis(*begun)) m_here.reset();
  }

  /// False if the protocol lacks the position of the last reading, or if another position at the same axis
  /// angle was begun after that position.
  bool isKnown() const { return m_here.has_value(); }
  std::size_t here() const { return *m_here; }  ///< index into the protocol's positions
  bool isTurned() const { return m_isTurned; }  ///< the other position has a zero, and no reading yet

  template <typename Wanted>
  Index firstLeft(std::size_t position, Wanted isWanted) const {
    for (std::size_t i = 0; i < all().size(); ++i)
      if (all()[i].planned.protocolPosition == position && !isThere(all()[i]) && isWanted(all()[i].planned))
        return i;
    return {};
  }

  Index zero(std::size_t position, bool isAfter) const {
    return firstLeft(position, [=](const PlannedSighting& planned) {
      return planned.isZero && planned.isAfter == isAfter;
    });
  }

  /// Whether the current position lacks a zero before its readings. Once it has readings, the zero in face 1
  /// suffices.
  bool lacksZero() const {
    const Index missing = zero(m_isTurned ? *m_other : *m_here, false);
    return missing && (m_isTurned || all()[*missing].planned.face == 1);
  }

  Index place(std::size_t position, int point, int face) const {
    return firstLeft(position, [=](const PlannedSighting& planned) {
      return !planned.isZero && planned.point == point && planned.face == face;
    });
  }

  /// Index of a possible sighting or of the zero due before it; absent if none is left at its place and face.
  /// A sighting that turns the axis requires `canTurnAxis()`.
  Index indexOf(const NextSighting& next) const {
    if (!next.turnsAxis) return m_isTurned ? Index() : place(*m_here, next.point, next.face);
    const Index there = place(*m_other, next.point, next.face), zeroBefore = zero(*m_other, false);
    return there && zeroBefore ? zeroBefore : there;
  }

  bool canTurnAxis() const { return m_other.has_value(); }

 private:
  const SightingProtocol& m_protocol;
  const ProtocolProgress& m_progress;
  Index m_here, m_other;  ///< the position of the last reading, and the next at the other axis angle
  bool m_isTurned = false;

  const std::vector<FollowedSighting>& all() const { return m_progress.sightings; }
  bool isOtherAxis(std::size_t position) const {
    return m_protocol.positions[position].axisDeg != m_protocol.positions[*m_here].axisDeg;
  }
  bool isBegun(std::size_t position) const {
    return std::ranges::any_of(all(), [&](const FollowedSighting& followed) {
      return followed.planned.protocolPosition == position && isThere(followed);
    });
  }
};

/// The first of the ranked sightings that is left, and others nearly as informative; absent if none is left.
std::optional<SightingChoice> mostInformative(const std::vector<NextSighting>& ranked,
                                              const Remaining& left) {
  constexpr double nearly = 0.9;
  constexpr std::size_t most = 2;
  std::optional<SightingChoice> choice;
  for (const NextSighting& next : ranked) {
    const Index index = left.indexOf(next);
    if (!index) continue;
    if (!choice) {
      choice.emplace();
      choice->next = *index;
      choice->worth = next;
    } else if (std::vector<std::size_t>& others = choice->alternatives;
               others.size() < most && next.perMinute() >= nearly * choice->worth.perMinute() &&
               *index != choice->next && std::ranges::find(others, *index) == others.end()) {
      others.push_back(*index);
    }
  }
  return choice;
}

/// Changes the choice to the first place of the last position once more, then to its closing zero, until both
/// have been sighted.
void close(SightingChoice& choice, const Remaining& left, const ArcMeasurement& arc) {
  const Sighting& first = arc.sightings.front();
  const auto isAgain = [&](const Sighting& sighting) {
    return sighting.point == first.point && sighting.round != first.round;
  };
  const Index again =
      std::ranges::any_of(arc.sightings, isAgain)
          ? Index()
          : left.firstLeft(left.here(), [&](const PlannedSighting& planned) {
              return !planned.isZero && planned.point == first.point && planned.round != first.round;
            });
  const Index zero = left.zero(left.here(), true);
  if (!again && !zero) return;
  choice.next = again ? *again : *zero;
  choice.reason = again ? SightingChoice::Reason::EarlyPlace : SightingChoice::Reason::ClosingZero;
}

}  // namespace

SightingPlan openPlan(const SightingProtocol& protocol) {
  SightingPlan plan{.places = {}, .faces = {}};
  std::set<int> faces, points;
  plan.rows = 0;
  for (const PlannedSighting& planned : sightingsInOrder(listedOrder(protocol))) {
    if (planned.isZero) continue;
    ++plan.rows;
    faces.insert(planned.face);
    points.insert(planned.point);
  }
  plan.faces.assign(faces.begin(), faces.end());
  const std::vector<std::size_t> one(protocol.positions.size(), 0);
  for (const auto& [place, radians] : nominalPlaces(protocol, one))
    if (points.erase(place.second) > 0) plan.places.push_back({place.second, Angle::fromRadians(radians)});
  plan.readsSlider = protocol.readsSlider;
  plan.minutes = protocol.minutes;
  return plan;
}

std::optional<SightingChoice> chooseSighting(const Measurement& measurement, const SightingProtocol& protocol,
                                             const ProtocolProgress& progress) {
  if (measurement.rows > mostForChoice) return std::nullopt;
  const ArcMeasurement* last = nullptr;
  for (const ArcMeasurement& arc : measurement.arcs)
    if (!arc.sightings.empty() && (!last || arc.sightings.back().order > last->sightings.back().order))
      last = &arc;
  if (!last) return std::nullopt;
  const Remaining left(protocol, progress, last->position);
  if (!left.isKnown() || left.lacksZero()) return std::nullopt;
  SightingPlan plan = openPlan(protocol);
  plan.canTurnAxis = left.canTurnAxis();
  auto state = sessionSoFar(measurement, plan);
  if (!state) return std::nullopt;
  std::optional<SightingChoice> choice = mostInformative(state->ranked, left);
  if (!choice) return std::nullopt;
  if (isEnough(*state) && !left.isTurned()) close(*choice, left, *last);
  choice->soFar = *std::move(state);
  return choice;
}

std::optional<SightingChoice> followChoice(const Session& session, const Measurement& measurement,
                                           const SightingProtocol& protocol, ProtocolProgress& progress) {
  if (!protocol.isByWorth) return std::nullopt;
  auto choice = chooseSighting(measurement, protocol, progress);
  if (choice) progress = progressOf(session, protocol, choice->next);
  return choice;
}

std::optional<SightingsAhead> sightingsAhead(const Measurement& measurement, const SightingProtocol& protocol,
                                             double uncertainty, const Diagnosis* diagnosis,
                                             const std::stop_token& stop) {
  const bool isBegun =
      std::ranges::any_of(measurement.arcs, [](const ArcMeasurement& arc) { return !arc.sightings.empty(); });
  if (!protocol.isByWorth || !isBegun || measurement.rows > mostForChoice) return std::nullopt;
  SightingPlan plan = openPlan(protocol);
  if (plan.places.empty()) return std::nullopt;
  plan.canTurnAxis = protocol.positions.size() > measurement.arcs.size();
  if (diagnosis) plan.noise = diagnosis->noise;
  return sightingsFor(uncertainty, measurement, plan, mostAhead, stop);
}

}  // namespace alidade
