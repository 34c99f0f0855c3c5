#include "ui/entry/readings_finder.h"

#include <algorithm>

#include "ui/document/reading_column.h"
#include "ui/document/session_document.h"
#include "ui/panels/readings/find_bar.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"

namespace alidade::ui {

ReadingsFinder::ReadingsFinder(SessionDocument& document, PositionTabs& positions, FindBar& bar)
    : QObject(&bar), m_document(document), m_positions(positions), m_bar(bar) {
  connect(&bar, &FindBar::wanted, this, &ReadingsFinder::findText);
  connect(&bar, &FindBar::closed, this, [this] {
    if (ReadingsTable* table = m_positions.currentTable()) table->setFocus();
  });
}

void ReadingsFinder::find() {
  m_bar.start();
}

void ReadingsFinder::findAgain(bool forward) {
  m_text.isEmpty() ? find() : findText(m_text, forward);
}

void ReadingsFinder::findText(const QString& text, bool forward) {
  emit commitWanted();
  m_text = text;
  const ReadingsTable* table = m_positions.currentTable();
  const QModelIndex current = table ? table->currentIndex() : QModelIndex();
  Place from{.position = static_cast<std::size_t>(std::max(0, m_positions.currentIndex())), .reading = 0};
  if (current.isValid()) {
    from.reading = static_cast<std::size_t>(current.row());
    const RowField* field = infoOf(static_cast<ReadingColumn>(current.column())).field;
    if (field) from.field = std::string(field->key);
  }
  const auto place = findInReadings(m_document.session(), from, text, forward);
  m_bar.showMessage(place ? QString() : tr("Not found"));
  if (place) emit found(*place, !m_bar.isVisible());
}

}  // namespace alidade::ui
