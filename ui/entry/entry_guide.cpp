#include "ui/entry/entry_guide.h"

#include <QApplication>
#include <QKeyEvent>
#include <QTimer>
#include <algorithm>

#include "core/session/entry.h"
#include "ui/document/field.h"
#include "ui/document/session_document.h"
#include "ui/entry/bench_display.h"
#include "ui/entry/stray_digits.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/settings/entry_tone.h"
#include "ui/text/next_reading_text.h"

namespace alidade::ui {

namespace {

/// The text of a reading; empty if the session has no such row.
std::string textAt(const Session& session, std::size_t position, std::size_t row, ReadingColumn column) {
  if (position >= session.positions.size() || row >= session.positions[position].readings.size()) return {};
  return session.positions[position].readings[row].*readingText(column);
}

}  // namespace

EntryGuide::EntryGuide(SessionDocument& document, PositionTabs& positions, QWidget& window)
    : QObject(&window), m_document(document), m_positions(positions), m_window(window) {
  connect(new StrayDigits(window), &StrayDigits::typed, this,
          [this](QKeyEvent* event) { takeDigit(*event); });
  connect(&positions, &PositionTabs::entered, this, &EntryGuide::reportEntry);
  connect(&positions, &PositionTabs::zeroEntered, this, [this] { goOnSoon(true); });
  connect(&positions, &QTabWidget::currentChanged, this, &EntryGuide::showNext);
  connect(&document, &SessionDocument::changed, this, &EntryGuide::dropDoubt);
}

void EntryGuide::goToAxis(int axisDeg) {
  emit commitWanted();
  const auto& positions = m_document.session().positions;
  const int count = static_cast<int>(positions.size());
  const ReadingsTable* table = m_positions.currentTable();
  // If the table in front has the focus, the search starts after its position, else at the first position.
  const int begin = table && table->hasFocus() ? m_positions.currentIndex() + 1 : 0;
  for (int i = 0; i < count; ++i) {
    const int position = (begin + i) % count;
    const auto axis = axisEntry(positions[static_cast<std::size_t>(position)].axisDeg);
    if (!axis || *axis != axisDeg) continue;
    return goToNextEntryOf(static_cast<std::size_t>(position));
  }
  emit positionWanted(axisDeg);
}

void EntryGuide::goToNextEntry() {
  const auto here = static_cast<std::size_t>(std::max(0, m_positions.currentIndex()));
  const auto next = entryToLeadTo(m_document.session(), here, m_document.chosenSighting());
  if (next && !next->field.empty()) return emit revealWanted({.field = next->field});
  if (!m_positions.currentTable()) return;
  next ? goTo(*next) : goToNextEntryOf(here);
}

void EntryGuide::goTo(const EntryToCome& next) {
  m_positions.showPosition(next.position);
  if (!next.zero.empty()) return goToMissingOf(next.position, next.zero);
  const auto& rows = m_document.session().positions[next.position].readings;
  const bool isHalf = next.row < rows.size() && isHalfFilled(rows[next.row]);
  ReadingsTable* table = m_positions.currentTable();
  if (isHalf) {
    table->selectCell(static_cast<int>(next.row), rows[next.row].horizontal.empty()
                                                      ? ReadingColumn::Horizontal
                                                      : ReadingColumn::Vertical);
  } else {
    table->goToNextEntry();
  }
  table->setFocus(Qt::ShortcutFocusReason);
}

/// Focuses the first circle of a pointing zero that has no reading.
void EntryGuide::goToMissingOf(std::size_t position, const std::string& zero) {
  for (const char* circle : {".horizontal", ".vertical"})
    if (const Place place{.position = position, .field = zero + circle};
        fieldText(m_document.session(), place).empty())
      return emit revealWanted(place);
}

/// Goes on after the event of the key that ended the entry, which moves the focus itself.
void EntryGuide::goOnSoon(bool isFromZero) {
  QTimer::singleShot(0, this, [this, isFromZero] { goOn(isFromZero); });
}

/// Moves the focus if the protocol's next sighting is a pointing zero or in another position, and from a zero
/// in any case. While the position in front lacks readings, a zero that was skipped before existing readings
/// does not move it.
void EntryGuide::goOn(bool isFromZero) {
  const Session& session = m_document.session();
  const auto progress = progressIn(session, m_document.chosenSighting());
  const auto here = static_cast<std::size_t>(std::max(0, m_positions.currentIndex()));
  if (!progress || !progress->next || !progress->sightings[*progress->next].position) return;
  const FollowedSighting& next = progress->sightings[*progress->next];
  const bool isZero = next.planned.isZero;
  const bool isBefore =
      isZero && !next.planned.isAfter && !session.positions[*next.position].readings.empty();
  if (isBefore && nextPlaceIn(*progress, here)) return;
  if (isFromZero || isZero || next.position != here)
    if (const auto entry = entryToCome(session, here, &*progress)) goTo(*entry);
}

/// Moves to the missing pointing zero of the position, or else to its next reading.
void EntryGuide::goToNextEntryOf(std::size_t position) {
  m_positions.showPosition(position);
  for (const char* field : {"pointing_zero.horizontal", "pointing_zero.vertical"})
    if (const Place place{.position = position, .field = field};
        fieldText(m_document.session(), place).empty())
      return emit revealWanted(place);
  ReadingsTable* table = m_positions.currentTable();
  table->goToNextEntry();
  table->setFocus(Qt::ShortcutFocusReason);
}

/// Forwards a digit typed outside any entry to the next missing entry.
void EntryGuide::takeDigit(QKeyEvent& event) {
  goToNextEntry();
  QWidget* entry = QApplication::focusWidget();
  if (!entry || entry->window() != &m_window)
    return emit remark(tr("No entry here accepts “%1”.").arg(event.text()));
  QKeyEvent again(event.type(), event.key(), event.modifiers(), event.text());
  QCoreApplication::sendEvent(entry, &again);
}

void EntryGuide::reportEntry(std::size_t position, std::size_t row, ReadingColumn column,
                             const QString& doubt) {
  if (m_bench) m_bench->setDoubt(doubt);
  m_doubted = Doubted{position, row, column, textAt(m_document.session(), position, row, column)};
  goOnSoon(false);
  if (doubt.isEmpty()) return;
  emit remark(doubt);
  if (hasTone()) QApplication::beep();
}

/// Drops a doubt when its reading is another, or belongs to another session.
void EntryGuide::dropDoubt(const SessionChange& change) {
  if (!m_doubted) return;
  const auto& [position, row, column, typed] = *m_doubted;
  if (change.kind != SessionChange::Kind::Everything &&
      textAt(m_document.session(), position, row, column) == typed)
    return;
  m_doubted.reset();
  if (m_bench) m_bench->setDoubt({});
}

void EntryGuide::showNext() {
  const auto position = static_cast<std::size_t>(std::max(0, m_positions.currentIndex()));
  emit nextChanged(m_evaluation ? nextEntryText(*m_evaluation, position) : QString());
  if (m_bench) m_bench->setPosition(position);
}

void EntryGuide::setEvaluation(const SharedEvaluation& evaluation) {
  m_evaluation = evaluation;
  if (m_bench) m_bench->setEvaluation(evaluation);
  showNext();
}

void EntryGuide::setHeadline(const Headline& headline) {
  m_headline = headline;
  if (m_bench) m_bench->setHeadline(headline);
}

void EntryGuide::setLargeDisplayShown(bool shown) {
  if (!m_bench && shown) {
    m_bench = new BenchDisplay(&m_window);
    m_bench->setHeadline(m_headline);
    m_bench->setEvaluation(m_evaluation);
  }
  if (m_bench) m_bench->setVisible(shown);
  showNext();
}

void EntryGuide::toggleLargeDisplay() {
  setLargeDisplayShown(!m_bench || !m_bench->isVisible());
}

}  // namespace alidade::ui
