#include "ui/commands/move_rows.h"

#include <QCoreApplication>
#include <utility>

#include "ui/commands/replace_readings.h"
#include "ui/document/session_document.h"
#include "ui/text/position_text.h"

namespace alidade::ui {

void moveRows(SessionDocument& document, std::size_t from, const std::vector<std::size_t>& rows,
              std::size_t to) {
  const auto& positions = document.session().positions;
  if (from == to || from >= positions.size() || to >= positions.size()) return;
  const std::vector<Reading>& source = positions[from].readings;
  std::vector<Reading> moved;
  for (const std::size_t row : rows)
    if (row < source.size()) moved.push_back(source[row]);
  if (moved.empty()) return;
  const QString text = QCoreApplication::translate("MoveRows", "Move %1 readings to %2")
                           .arg(moved.size())
                           .arg(positionText(document.session(), to));
  document.beginTogether(text);
  patchReadings(document, from, ReadingsPatch::removing(source, rows), text, journal_reasons::moved);
  replaceReadings(document, to, positions[to].readings.size(), 0, moved, text, journal_reasons::moved);
  document.endTogether();
}

}  // namespace alidade::ui
