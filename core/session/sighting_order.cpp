#include "core/session/sighting_order.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

#include "core/base/number_text.h"
#include "core/session/protocol_progress.h"
#include "core/session/row_fields.h"
#include "core/session/sighting_protocol.h"

namespace alidade {

namespace {

int numberOr(const std::string& text, int fallback) {
  const Result<int> number = parseWhole(text);
  return number ? *number : fallback;
}

int roundOf(const Reading& row) {
  return numberOr(row.round, 1);
}

int faceOf(const Reading& row) {
  return numberOr(row.face, 1);
}

/// Do the rows have the same round and face? Equal texts are not parsed: there may be very many rows.
bool isOfOneStretch(const Reading& a, const Reading& b) {
  return (a.round == b.round || roundOf(a) == roundOf(b)) && (a.face == b.face || faceOf(a) == faceOf(b));
}

bool isSamePlace(const Reading& a, const Reading& b) {
  return a.point == b.point && isOfOneStretch(a, b);
}

Reading keysOf(const Reading& row) {
  Reading keys;
  keys.point = row.point;
  keys.round = row.round;
  keys.face = row.face;
  return keys;
}

Reading at(const Reading& place, int round, int face) {
  Reading row;
  row.point = place.point;
  row.round = std::to_string(round);
  row.face = std::to_string(face);
  return row;
}

std::size_t stretchBefore(const std::vector<Reading>& rows, std::size_t end) {
  while (end > 1 && isOfOneStretch(rows[end - 2], rows[end - 1])) --end;
  return end == 0 ? 0 : end - 1;
}

/// The next row in another position that begins with the rows of `position`; or null.
const Reading* asInAnotherPosition(const Session& session, std::size_t position) {
  const std::vector<Reading>& rows = session.positions[position].readings;
  for (std::size_t i = 0; i < session.positions.size(); ++i) {
    const std::vector<Reading>& others = session.positions[i].readings;
    if (i != position && others.size() > rows.size() &&
        std::equal(rows.begin(), rows.end(), others.begin(), isSamePlace))
      return &others[rows.size()];
  }
  return nullptr;
}

/// The row with the next point if the last stretch repeats the stretch before, forwards or backwards; else
/// null.
const Reading* asInTheStretchBefore(const std::vector<Reading>& rows) {
  const std::size_t first = lastStretch(rows);
  if (first == 0) return nullptr;
  const std::size_t before = stretchBefore(rows, first), length = first - before;
  const std::size_t done = rows.size() - first;
  if (done >= length) return nullptr;
  const auto isLike = [&](auto placeOf) {
    for (std::size_t i = 0; i < done; ++i)
      if (rows[first + i].point != rows[placeOf(i)].point) return false;
    return true;
  };
  const auto back = [&](std::size_t i) { return first - 1 - i; };
  const auto again = [&](std::size_t i) { return before + i; };
  if (isLike(back)) return &rows[back(done)];
  return isLike(again) ? &rows[again(done)] : nullptr;
}

int lastRound(const std::vector<Reading>& rows) {
  int round = 0;
  for (const Reading& row : rows) round = std::max(round, roundOf(row));
  return round;
}

/// Moves `next`, a copy of the last row's keys, to the next point. A way back ends at point 1, where the next
/// round begins.
void moveOn(Reading& next, const std::vector<Reading>& rows, int last, bool isDescending) {
  if (isDescending && last <= 1)
    next.round = std::to_string(lastRound(rows) + 1);
  else
    next.point = std::to_string(isDescending ? last - 1 : last + 1);
}

void moveInDirectionOfLastTwo(Reading& next, const std::vector<Reading>& rows) {
  const int last = rows.empty() ? 0 : numberOr(rows.back().point, static_cast<int>(rows.size()));
  const bool hasTwo = rows.size() > 1 && isOfOneStretch(rows[rows.size() - 2], rows.back());
  moveOn(next, rows, last, hasTwo && numberOr(rows[rows.size() - 2].point, 0) == last + 1);
}

/// The last places, if each place is sighted in both faces before the slider moves.
struct Pairs {
  bool isHalf = false;    ///< the last place lacks its second face
  int firstFace = 1;      ///< first face of the last whole pair
  int faceBefore = 0;     ///< first face of the pair before; 0 if there is none
  std::size_t whole = 0;  ///< index of the first row of the last whole pair
};

std::optional<Pairs> pairsAtTheEnd(const std::vector<Reading>& rows) {
  const auto isPair = [&](std::size_t end) {
    if (end < 2) return false;
    const Reading &a = rows[end - 2], &b = rows[end - 1];
    return a.point == b.point && roundOf(a) == roundOf(b) && faceOf(a) != faceOf(b);
  };
  const bool isHalf = !isPair(rows.size());
  const std::size_t end = rows.size() - (isHalf ? 1 : 0);
  if (!isPair(end)) return {};
  return Pairs{isHalf, faceOf(rows[end - 2]), isPair(end - 2) ? faceOf(rows[end - 4]) : 0, end - 2};
}

/// The next row if the last rows are pairs of faces; it continues their order, 1 2 1 2 or 1 2 2 1.
std::optional<Reading> asInPairs(const std::vector<Reading>& rows) {
  const auto pairs = rows.empty() ? std::nullopt : pairsAtTheEnd(rows);
  if (!pairs) return {};
  Reading next = keysOf(rows.back());
  if (pairs->isHalf) {
    next.face = std::to_string(3 - faceOf(rows.back()));
    return next;
  }
  const int last = numberOr(rows.back().point, 0);
  moveOn(next, rows, last, pairs->faceBefore != 0 && numberOr(rows[pairs->whole - 1].point, 0) == last + 1);
  const bool isAlternating = pairs->faceBefore != 0 && pairs->faceBefore != pairs->firstFace;
  next.face = std::to_string(isAlternating ? 3 - pairs->firstFace : pairs->firstFace);
  return next;
}

/// The next row in the session's protocol, while the position is incomplete.
std::optional<Reading> asInTheProtocol(const Session& session, std::size_t position,
                                       std::optional<std::size_t> chosen) {
  const auto progress = progressIn(session, chosen);
  const auto next = progress ? nextPlaceIn(*progress, position) : std::nullopt;
  if (!next) return {};
  Reading row = rowFor(progress->sightings[*next].planned);
  // Round 1 and face 1 are written out if they are written out in the last row.
  const std::vector<Reading>& rows = session.positions[position].readings;
  if (!rows.empty() && row.round.empty() && !rows.back().round.empty()) row.round = "1";
  if (!rows.empty() && row.face.empty() && !rows.back().face.empty()) row.face = "1";
  return row;
}

}  // namespace

std::size_t lastStretch(const std::vector<Reading>& rows) {
  return stretchBefore(rows, rows.size());
}

Reading followingReading(const Session& session, std::size_t position, std::optional<std::size_t> chosen) {
  const std::vector<Reading>& rows = session.positions.at(position).readings;
  if (const auto planned = asInTheProtocol(session, position, chosen)) return *planned;
  if (const Reading* other = asInAnotherPosition(session, position)) return keysOf(*other);
  if (const auto paired = asInPairs(rows)) return *paired;
  Reading next = rows.empty() ? Reading() : keysOf(rows.back());
  if (const Reading* place = asInTheStretchBefore(rows))
    next.point = place->point;
  else
    moveInDirectionOfLastTwo(next, rows);
  return next;
}

std::vector<Reading> furtherRows(const std::vector<Reading>& rows, FurtherRows which) {
  if (rows.empty()) return {};
  const std::size_t first = lastStretch(rows);
  const int round = lastRound(rows);
  const int face = which == FurtherRows::WayBackInTwo ? 3 - faceOf(rows.back()) : faceOf(rows.back());
  std::vector<Reading> laidOut;
  for (std::size_t i = first; i < rows.size(); ++i) laidOut.push_back(at(rows[i], round + 1, face));
  if (which != FurtherRows::AnotherRound) std::ranges::reverse(laidOut);
  return laidOut;
}

}  // namespace alidade
