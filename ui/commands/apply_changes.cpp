#include "ui/commands/apply_changes.h"

#include <algorithm>
#include <map>

#include "ui/commands/replace_readings.h"
#include "ui/document/reading_column.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

/// The first to the last row that differs, of one position.
struct Rows {
  std::size_t first = 0;
  std::vector<Reading> readings;
};

bool exists(const Session& session, const Place& place) {
  return place.position && place.reading && *place.position < session.positions.size() &&
         *place.reading < session.positions[*place.position].readings.size();
}

Rows changedRows(const std::vector<Reading>& before, std::vector<Reading> after) {
  std::size_t first = 0, end = before.size();
  while (first < end && before[first] == after[first]) ++first;
  while (end > first && before[end - 1] == after[end - 1]) --end;
  const auto at = [&](std::size_t row) { return std::next(after.begin(), static_cast<std::ptrdiff_t>(row)); };
  return {first, {at(first), at(end)}};
}

}  // namespace

void applyChanges(SessionDocument& document, const std::vector<CellChange>& changes,
                  const QString& undoText) {
  std::map<std::size_t, std::vector<Reading>> edited;
  for (const CellChange& change : changes) {
    if (!exists(document.session(), change.where)) continue;
    const std::size_t position = *change.where.position;
    auto& readings =
        edited.try_emplace(position, document.session().positions[position].readings).first->second;
    readings[*change.where.reading].*readingText(readingColumn(change.where.field)) = change.text;
  }
  std::map<std::size_t, Rows> rows;
  for (auto& [position, readings] : edited) {
    Rows changed = changedRows(document.session().positions[position].readings, std::move(readings));
    if (!changed.readings.empty()) rows.emplace(position, std::move(changed));
  }
  if (rows.size() > 1) document.beginTogether(undoText);
  for (const auto& [position, changed] : rows)
    replaceReadings(document, position, changed.first, changed.readings.size(), changed.readings, undoText);
  if (rows.size() > 1) document.endTogether();
}

}  // namespace alidade::ui
