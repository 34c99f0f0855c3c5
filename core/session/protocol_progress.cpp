#include "core/session/protocol_progress.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "core/session/entry.h"
#include "core/session/row_fields.h"

namespace alidade {

namespace {

/// A position's axis and its repeat at that axis.
using AxisRepeat = std::pair<int, int>;

std::vector<AxisRepeat> axesOf(const SightingProtocol& protocol) {
  std::vector<AxisRepeat> axes;
  std::map<int, int> repeats;
  for (const ProtocolPosition& position : protocol.positions)
    axes.emplace_back(position.axisDeg, ++repeats[position.axisDeg]);
  return axes;
}

/// Indices of positions by axis and repeat, counted as in `Measurement`. Axis and repeat identify a position
/// in any order of the file.
std::map<AxisRepeat, std::size_t> positionsOf(const Session& session) {
  std::map<AxisRepeat, std::size_t> positions;
  std::map<int, int> repeats;
  for (std::size_t i = 0; i < session.positions.size(); ++i)
    if (const auto axis = axisEntry(session.positions[i].axisDeg))
      positions.emplace(AxisRepeat(*axis, ++repeats[*axis]), i);
  return positions;
}

/// The faces at the `index`-th place of a round.
std::vector<int> facesAt(const ProtocolRound& round, std::size_t index) {
  if (round.faces.size() <= 2) return round.faces;
  const auto first = round.faces.begin() + (index % 2 == 0 ? 0 : 2);
  return {first, first + 2};
}

struct RowState {
  std::size_t row = 0;
  bool isRead = false, isHalf = false, isExcluded = false;
  bool isRepeated = false;  ///< another row with the same sighting is read
};

using RowKey = std::tuple<int, int, int>;  ///< point, round, face

/// Point, round and face of the row at an index of its position; absent if an entry is unusable.
std::optional<RowKey> keyOf(const Reading& row, std::size_t index) {
  const auto point = wholeEntry(pointRule, row.point);
  const auto round = wholeEntry(roundRule, row.round);
  const auto face = wholeEntry(faceRule, row.face);
  if (!point || !round || !face) return std::nullopt;
  return RowKey(point->value_or(static_cast<int>(index) + 1), round->value_or(1), face->value_or(1));
}

/// The rows of a position by point, round and face. Of equal rows the first that is not excluded counts, else
/// the first.
std::map<RowKey, RowState> rowsOf(const Position& position) {
  std::map<RowKey, RowState> rows;
  for (std::size_t i = 0; i < position.readings.size(); ++i) {
    const Reading& row = position.readings[i];
    const auto key = keyOf(row, i);
    if (!key) continue;
    const RowState state{.row = i,
                         .isRead = !row.horizontal.empty() && !row.vertical.empty(),
                         .isHalf = row.horizontal.empty() != row.vertical.empty(),
                         .isExcluded = row.excluded};
    const auto [known, isNew] = rows.emplace(*key, state);
    if (isNew) continue;
    const bool isRepeated = known->second.isRepeated || (known->second.isRead && state.isRead);
    if (known->second.isExcluded && !state.isExcluded) known->second = state;
    known->second.isRepeated = isRepeated;
  }
  return rows;
}

RowKey keyOf(const PlannedSighting& planned) {
  return {planned.point, planned.round, planned.face};
}

/// Are the rows of all positions together the first rows of the protocol, in its order?
bool doRowsFollow(const Session& session, const SightingProtocol& protocol) {
  const auto positions = positionsOf(session);
  std::vector<std::size_t> followed(session.positions.size());  // rows of each position
  bool isPassed = false;                                        // a sighting has no row
  for (const PlannedSighting& planned : sightingsInOrder(protocol)) {
    const auto position = positions.find({planned.axisDeg, planned.repeat});
    if (planned.isZero || position == positions.end()) continue;
    const std::vector<Reading>& rows = session.positions[position->second].readings;
    std::size_t& row = followed[position->second];
    isPassed = isPassed || row == rows.size();
    if (isPassed) continue;
    if (keyOf(rows[row], row) != keyOf(planned)) return false;
    ++row;
  }
  for (std::size_t i = 0; i < followed.size(); ++i)
    if (followed[i] < session.positions[i].readings.size()) return false;
  return true;
}

bool isSighted(const PointingZero& zero, const PlannedSighting& planned) {
  if (!planned.isAfter && planned.face == 1) return !zero.horizontal.empty() && !zero.vertical.empty();
  for (const ZeroSlot& slot : furtherZeros)
    if (slot.face == planned.face && slot.isAfter == planned.isAfter)
      return !(zero.*slot.sighting).horizontal.empty() && !(zero.*slot.sighting).vertical.empty();
  return false;
}

/// Follows the progress of a session in its protocol.
class Follower {
 public:
  Follower(const Session& session, const SightingProtocol& protocol, std::optional<std::size_t> chosen)
      : m_session(session), m_isByWorth(protocol.isByWorth), m_chosen(chosen) {
    const auto positions = positionsOf(session);
    for (const PlannedSighting& planned : sightingsInOrder(protocol)) {
      FollowedSighting followed{planned};
      const auto position = positions.find({planned.axisDeg, planned.repeat});
      if (position != positions.end()) followed.position = position->second;
      m_progress.sightings.push_back(followed);
    }
  }

  ProtocolProgress follow() {
    for (const Position& position : m_session.positions) m_rows.push_back(rowsOf(position));
    for (FollowedSighting& followed : m_progress.sightings) look(followed);
    if (!m_isByWorth) markOutOfTurn();
    m_progress.next = next();
    if (m_progress.next) m_progress.sightings[*m_progress.next].state = SightingState::Next;
    if (!m_isByWorth) markMissed();
    countUnplanned();
    return std::move(m_progress);
  }

 private:
  void look(FollowedSighting& followed) {
    if (!followed.position) return;
    const PlannedSighting& planned = followed.planned;
    if (planned.isZero) {
      if (isSighted(m_session.positions[*followed.position].zero, planned)) take(followed);
      return;
    }
    const auto row = m_rows[*followed.position].find(keyOf(planned));
    if (row == m_rows[*followed.position].end()) return;
    followed.row = row->second.row;
    followed.isRepeated = row->second.isRepeated;
    if (row->second.isExcluded) {
      followed.state = SightingState::Excluded;
      ++m_progress.excluded;
    } else if (row->second.isRead) {
      take(followed);
    }
  }

  void take(FollowedSighting& followed) {
    followed.state = SightingState::Taken;
    ++m_progress.taken;
  }

  /// Rows are in the order taken. A row is out of turn if the protocol has it before an earlier row of its
  /// position.
  void markOutOfTurn() {
    for (std::size_t position = 0; position < m_session.positions.size(); ++position) {
      std::vector<std::pair<std::size_t, std::size_t>> taken;  // row, index in the protocol
      for (std::size_t i = 0; i < m_progress.sightings.size(); ++i) {
        const FollowedSighting& followed = m_progress.sightings[i];
        if (followed.position == position && followed.row && isThere(followed))
          taken.emplace_back(*followed.row, i);
      }
      std::ranges::sort(taken);
      std::size_t latest = 0;
      for (const auto& [row, index] : taken) {
        if (index < latest) {
          m_progress.sightings[index].isOutOfTurn = true;
          ++m_progress.outOfTurn;
        }
        latest = std::max(latest, index);
      }
    }
  }

  bool isOf(std::size_t index, std::size_t protocolPosition) const {
    return m_progress.sightings[index].planned.protocolPosition == protocolPosition;
  }

  /// The sighting of the last row taken in a position; without such a row, the last of its zeros.
  std::optional<std::size_t> lastTaken(std::size_t protocolPosition) const {
    std::optional<std::size_t> last, lastZero;
    for (std::size_t i = 0; i < m_progress.sightings.size(); ++i) {
      const FollowedSighting& followed = m_progress.sightings[i];
      if (!isOf(i, protocolPosition) || !isThere(followed)) continue;
      if (followed.planned.isZero) {
        lastZero = i;
      } else if (!last || *followed.row > *m_progress.sightings[*last].row) {
        last = i;
      }
    }
    return last ? last : lastZero;
  }

  std::optional<std::size_t> firstLeft(std::size_t begin, std::size_t end, bool withZeros) const {
    for (std::size_t i = begin; i < end; ++i)
      if (!isThere(m_progress.sightings[i]) && (withZeros || !m_progress.sightings[i].planned.isZero))
        return i;
    return std::nullopt;
  }

  bool isHalfFilled(const FollowedSighting& followed) const {
    if (!followed.row || isThere(followed)) return false;
    return m_rows[*followed.position].at(keyOf(followed.planned)).isHalf;
  }

  /// The first zero of a position that has readings but lacks this zero; absent if there is none.
  std::optional<std::size_t> missingZero() const {
    std::optional<std::size_t> zero;
    for (std::size_t i = 0; i < m_progress.sightings.size(); ++i) {
      const FollowedSighting& followed = m_progress.sightings[i];
      const PlannedSighting& planned = followed.planned;
      if (planned.isZero && !planned.isAfter && planned.face == 1)
        zero = isThere(followed) ? std::nullopt : std::optional(i);
      if (!planned.isZero && isThere(followed) && zero && isOf(*zero, planned.protocolPosition)) return zero;
    }
    return std::nullopt;
  }

  std::optional<std::size_t> next() const {
    const std::size_t count = m_progress.sightings.size();
    for (std::size_t i = 0; i < count; ++i)
      if (isHalfFilled(m_progress.sightings[i])) return i;
    if (const auto zero = missingZero()) return zero;
    if (m_isByWorth && m_chosen && *m_chosen < count && !isThere(m_progress.sightings[*m_chosen]))
      return m_chosen;
    std::optional<std::size_t> begun;
    for (std::size_t i = 0; i < count; ++i)
      if (isThere(m_progress.sightings[i])) begun = m_progress.sightings[i].planned.protocolPosition;
    if (begun) {
      std::size_t first = 0;
      while (!isOf(first, *begun)) ++first;
      std::size_t end = first;
      while (end < count && isOf(end, *begun)) ++end;
      if (const auto in = nextWithin(first, end, *lastTaken(*begun))) return in;
    }
    return firstLeft(0, count, true);
  }

  /// The first reading left after `last`, then a skipped reading, then a zero. If `last` is a zero before the
  /// readings, the first sighting left.
  std::optional<std::size_t> nextWithin(std::size_t first, std::size_t end, std::size_t last) const {
    const bool isAtZeros =
        m_progress.sightings[last].planned.isZero && !m_progress.sightings[last].planned.isAfter;
    if (isAtZeros) return firstLeft(first, end, true);
    if (const auto onward = firstLeft(last + 1, end, false)) return onward;
    if (const auto missed = firstLeft(first, last, false)) return missed;
    return firstLeft(first, end, true);
  }

  void markMissed() {
    bool isPassed = false;  // a later sighting of the position exists
    for (std::size_t i = m_progress.sightings.size(); i-- > 0;) {
      FollowedSighting& followed = m_progress.sightings[i];
      const std::size_t position = followed.planned.protocolPosition;
      if (i + 1 == m_progress.sightings.size() || !isOf(i + 1, position)) isPassed = false;
      if (isThere(followed)) isPassed = true;
      if (followed.state != SightingState::Left || !isPassed) continue;
      followed.state = SightingState::Missed;
      ++m_progress.missed;
    }
  }

  void countUnplanned() {
    std::set<std::pair<std::size_t, RowKey>> planned;
    for (const FollowedSighting& followed : m_progress.sightings)
      if (followed.position && !followed.planned.isZero)
        planned.emplace(*followed.position, keyOf(followed.planned));
    for (std::size_t position = 0; position < m_rows.size(); ++position)
      for (const auto& [key, row] : m_rows[position])
        if (row.isRead && !row.isExcluded && !planned.contains({position, key})) ++m_progress.unplanned;
  }

  const Session& m_session;
  const bool m_isByWorth;
  const std::optional<std::size_t> m_chosen;
  std::vector<std::map<RowKey, RowState>> m_rows;
  ProtocolProgress m_progress;
};

}  // namespace

std::vector<PlannedSighting> sightingsInOrder(const SightingProtocol& protocol) {
  std::vector<PlannedSighting> sightings;
  const std::vector<AxisRepeat> axes = axesOf(protocol);
  for (std::size_t p = 0; p < protocol.positions.size(); ++p) {
    const ProtocolPosition& position = protocol.positions[p];
    const std::vector<ProtocolPlace>& places = protocol.placesOf(position);
    const PlannedSighting here{.protocolPosition = p, .axisDeg = axes[p].first, .repeat = axes[p].second};
    const auto sightZeros = [&](const std::vector<int>& faces, bool isAfter) {
      for (const int face : faces) {
        PlannedSighting zero = here;
        zero.isZero = true;
        zero.isAfter = isAfter;
        zero.face = face;
        sightings.push_back(zero);
      }
    };
    sightZeros(position.zeros.before, false);
    for (std::size_t r = 0; r < position.rounds.size(); ++r) {
      const ProtocolRound& round = position.rounds[r];
      for (std::size_t i = 0; i < places.size(); ++i) {
        PlannedSighting sighting = here;
        sighting.place = round.isBack ? places.size() - 1 - i : i;
        sighting.point = places[sighting.place].point;
        sighting.round = static_cast<int>(r) + 1;
        for (const int face : facesAt(round, i)) {
          sighting.face = face;
          sightings.push_back(sighting);
        }
      }
    }
    sightZeros(position.zeros.after, true);
  }
  return sightings;
}

Result<std::optional<SightingProtocol>> protocolOf(const Session& session) {
  auto protocol = statedProtocol(session);
  if (protocol && *protocol && (*protocol)->isYielding && !doRowsFollow(session, **protocol))
    return std::optional<SightingProtocol>();
  return protocol;
}

SightingMinutes sightingMinutesOf(const Session& session) {
  const auto protocol = protocolOf(session);
  return protocol && *protocol ? (*protocol)->minutes : SightingMinutes();
}

ProtocolProgress progressOf(const Session& session, const SightingProtocol& protocol,
                            std::optional<std::size_t> chosen) {
  return Follower(session, protocol, chosen).follow();
}

std::optional<ProtocolProgress> progressIn(const Session& session, std::optional<std::size_t> chosen) {
  const auto protocol = protocolOf(session);
  if (!protocol || !*protocol) return std::nullopt;
  return progressOf(session, **protocol, chosen);
}

std::optional<std::size_t> nextPlaceIn(const ProtocolProgress& progress, std::size_t position) {
  const auto isOpen = [&](std::size_t i) {
    const FollowedSighting& followed = progress.sightings[i];
    return followed.position == position && !followed.planned.isZero && !isThere(followed);
  };
  if (progress.next && isOpen(*progress.next)) return progress.next;
  std::optional<std::size_t> missed;
  for (std::size_t i = 0; i < progress.sightings.size(); ++i) {
    if (!isOpen(i)) continue;
    if (progress.sightings[i].state != SightingState::Missed) return i;
    if (!missed) missed = i;
  }
  return missed;
}

Reading rowFor(const PlannedSighting& planned) {
  Reading row;
  row.point = std::to_string(planned.point);
  row.round = planned.round == 1 ? "" : std::to_string(planned.round);
  row.face = planned.face == 1 ? "" : std::to_string(planned.face);
  return row;
}

std::string zeroField(const PlannedSighting& planned) {
  for (const ZeroSlot& slot : furtherZeros)
    if (slot.face == planned.face && slot.isAfter == planned.isAfter) return zeroField(slot);
  return "pointing_zero";
}

std::string zeroField(const ZeroSlot& slot) {
  return std::string("pointing_zero.") + slot.key;
}

std::vector<int> positionsLacking(const Session& session, const SightingProtocol& protocol) {
  const auto positions = positionsOf(session);
  std::vector<int> lacking;
  for (const AxisRepeat& axis : axesOf(protocol))
    if (!positions.contains(axis)) lacking.push_back(axis.first);
  return lacking;
}

}  // namespace alidade
