#include "ui/commands/apply_changes.h"

#include <map>
#include <utility>
#include <vector>

#include "ui/commands/replace_readings.h"
#include "ui/document/reading_column.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

bool exists(const Session& session, const Place& place) {
  return place.position && place.reading && *place.position < session.positions.size() &&
         *place.reading < session.positions[*place.position].readings.size();
}

}  // namespace

void applyChanges(SessionDocument& document, const std::vector<CellChange>& changes,
                  const QString& undoText) {
  const Session& session = document.session();
  std::map<std::size_t, std::vector<NewText>> texts;
  for (const CellChange& change : changes)
    if (exists(session, change.where))
      texts[*change.where.position].push_back(
          {*change.where.reading, readingColumn(change.where.field), change.text});
  std::map<std::size_t, ReadingsPatch> patches;
  for (const auto& [position, news] : texts)
    if (ReadingsPatch patch(session.positions[position].readings, news); !patch.isEmpty())
      patches.emplace(position, std::move(patch));
  const bool isMany = patches.size() > 1;
  if (isMany) document.beginTogether(undoText);
  for (auto& [position, patch] : patches)
    patchReadings(document, position, std::move(patch), undoText, journal_reasons::suggestion);
  if (isMany) document.endTogether();
}

}  // namespace alidade::ui
