#include "core/session/entry_to_come.h"

#include <algorithm>
#include <vector>

#include "core/session/session_fields.h"
#include "core/session/sighting_order.h"

namespace alidade {

namespace {

bool isTyped(const Reading& row) {
  return !row.horizontal.empty() || !row.vertical.empty();
}

bool isStillOpen(const Reading& row) {
  return !row.excluded && (row.horizontal.empty() || row.vertical.empty());
}

bool lacksZero(const Position& position) {
  return position.zero.horizontal.empty() || position.zero.vertical.empty();
}

/// Does the position have half a pointing zero, or readings without a complete one?
bool isBegunWithoutZero(const Position& position) {
  const bool isHalf = position.zero.horizontal.empty() != position.zero.vertical.empty();
  return isHalf || (lacksZero(position) && std::ranges::any_of(position.readings, isTyped));
}

EntryToCome rowToCome(const Session& session, std::size_t position, std::size_t row) {
  const auto& rows = session.positions[position].readings;
  return {.position = position,
          .row = row,
          .sighting = row < rows.size() ? rows[row] : followingReading(session, position)};
}

EntryToCome zeroToCome(std::size_t position) {
  return {.position = position, .zero = "pointing_zero"};
}

/// Is the entry a new row below at least three rows of an arc?
bool isFurtherRow(const Session& session, const EntryToCome& entry) {
  constexpr std::size_t leastRows = 3;
  const std::size_t rows = session.positions[entry.position].readings.size();
  return entry.zero.empty() && entry.row >= rows && rows >= leastRows;
}

template <typename Wanted>
std::optional<EntryToCome> firstRow(const Session& session, std::size_t position, Wanted wanted) {
  const auto& rows = session.positions[position].readings;
  const auto found = std::ranges::find_if(rows, wanted);
  if (found == rows.end()) return std::nullopt;
  return rowToCome(session, position, static_cast<std::size_t>(found - rows.begin()));
}

EntryToCome followedToCome(const Session& session, const FollowedSighting& next) {
  const PlannedSighting& planned = next.planned;
  if (!planned.isZero) {
    const std::size_t row = next.row.value_or(session.positions[*next.position].readings.size());
    return {.position = *next.position, .row = row, .sighting = rowFor(planned)};
  }
  return {.position = *next.position,
          .zero = zeroField(planned),
          .zeroFace = planned.face,
          .isAfter = planned.isAfter};
}

/// The next entry of a position that has no half-finished entries; absent if the position is complete.
std::optional<EntryToCome> leftOf(const Session& session, std::size_t position,
                                  const ProtocolProgress* progress) {
  if (lacksZero(session.positions[position])) return zeroToCome(position);
  if (auto row = firstRow(session, position, isStillOpen)) return row;
  const bool isComplete =
      progress ? !nextPlaceIn(*progress, position).has_value() : hasAllOfAnother(session, position);
  if (isComplete) return std::nullopt;
  return rowToCome(session, position, session.positions[position].readings.size());
}

}  // namespace

bool isHalfFilled(const Reading& row) {
  return !row.excluded && row.horizontal.empty() != row.vertical.empty();
}

bool hasAllOfAnother(const Session& session, std::size_t position) {
  const std::vector<Reading>& rows = session.positions[position].readings;
  const auto isSame = [](const Reading& a, const Reading& b) {
    return a.point == b.point && a.round == b.round && a.face == b.face;
  };
  for (std::size_t i = 0; i < session.positions.size(); ++i)
    if (i != position && !rows.empty() && std::ranges::equal(rows, session.positions[i].readings, isSame))
      return true;
  return false;
}

std::optional<EntryToCome> entryToCome(const Session& session, std::size_t here,
                                       const ProtocolProgress* progress) {
  if (progress && progress->next && progress->sightings[*progress->next].position)
    return followedToCome(session, progress->sightings[*progress->next]);
  const std::size_t count = session.positions.size();
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < count; ++i) order.push_back((here + i) % count);
  for (const std::size_t position : order)
    if (auto row = firstRow(session, position, isHalfFilled)) return row;
  for (const std::size_t position : order)
    if (isBegunWithoutZero(session.positions[position])) return zeroToCome(position);
  for (const std::size_t position : order)
    if (auto entry = leftOf(session, position, progress)) return entry;
  return std::nullopt;
}

std::optional<EntryToCome> entryToComeOf(const Session& session, std::size_t here,
                                         std::optional<std::size_t> chosen) {
  const auto progress = progressIn(session, chosen);
  return entryToCome(session, here, progress ? &*progress : nullptr);
}

std::optional<EntryToCome> entryToLeadTo(const Session& session, std::size_t here,
                                         const ProtocolProgress* progress) {
  for (const char* field : {"geometry.distance_mm", "geometry.radius_mm"})
    if (sessionFieldNamed(field)->get(session).empty()) return EntryToCome{.field = field};
  const auto next = entryToCome(session, here, progress);
  if (!next || progress || !isFurtherRow(session, *next)) return next;
  const std::size_t count = session.positions.size();
  for (std::size_t i = 1; i < count; ++i)
    if (const std::size_t position = (next->position + i) % count; lacksZero(session.positions[position]))
      return zeroToCome(position);
  return next;
}

std::optional<EntryToCome> entryToLeadTo(const Session& session, std::size_t here,
                                         std::optional<std::size_t> chosen) {
  const auto progress = progressIn(session, chosen);
  return entryToLeadTo(session, here, progress ? &*progress : nullptr);
}

}  // namespace alidade
