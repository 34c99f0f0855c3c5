#include "ui/panels/readings/position_tabs.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/session/entry.h"
#include "ui/commands/change_positions.h"
#include "ui/document/session_document.h"
#include "ui/models/entry_watch.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/readings/zero_entries.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/settings/theme.h"
#include "ui/text/position_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int axes[] = {0, 180};

bool changesTabs(const SessionChange& change) {
  return change.kind == SessionChange::Kind::Everything || change.kind == SessionChange::Kind::Positions;
}

}  // namespace

PositionTabs::PositionTabs(SessionDocument& document, QWidget* parent)
    : QTabWidget(parent), m_document(document), m_watch(new EntryWatch(document, this)) {
  setDocumentMode(false);
  connect(&document, &SessionDocument::aboutToChange, this, [this](const SessionChange& change) {
    if (changesTabs(change)) clearPositions();
  });
  connect(&document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    if (changesTabs(change)) rebuild();
    if (change.kind == SessionChange::Kind::Field) nameTabs();
    followZeros();
  });
  // Queued, since a field is also committed while the current tab changes.
  connect(&document, &SessionDocument::changed, this, &PositionTabs::showMissing, Qt::QueuedConnection);
  for (const int axisDeg : axes) createMissingPage(axisDeg);
  rebuild();
  connect(
      m_watch, &EntryWatch::entered, this,
      [this](std::size_t position, std::size_t row, ReadingColumn column, const QString& doubt) {
        if (ReadingsTable* readings = table(position)) readings->readings().setDoubt(row, column, doubt);
        emit entered(position, row, column, doubt);
      },
      Qt::QueuedConnection);  // after the tables have processed the edit
}

void PositionTabs::clearPositions() {
  const std::size_t positions = m_tables.size();
  m_tables.clear();
  m_zeros.clear();
  for (std::size_t i = 0; i < positions; ++i) delete widget(0);
}

void PositionTabs::rebuild() {
  for (std::size_t position = 0; position < m_document.session().positions.size(); ++position) {
    insertTab(static_cast<int>(position), createPage(position), QString());
  }
  nameTabs();
  showMissing();
  showPosition(0);
  followZeros();
  for (ReadingsTable* table : m_tables) emit tableCreated(table);
}

void PositionTabs::createMissingPage(int axisDeg) {
  auto* page = new QWidget;
  auto* text = new QLabel(tr("The session has no position with the axis at %1°.\n"
                             "Δd needs the arc at 0° and at 180°.")
                              .arg(axisDeg));
  text->setAlignment(Qt::AlignCenter);
  text->setWordWrap(true);
  auto* button = new QPushButton(themeIcon(QStringLiteral("insert")), tr("Add position at %1°").arg(axisDeg));
  button->setObjectName(QStringLiteral("add position %1").arg(axisDeg));
  connect(button, &QPushButton::clicked, this, [this, axisDeg] { emit positionWanted(axisDeg); });
  auto* layout = new QVBoxLayout(page);
  layout->addStretch();
  layout->addWidget(text);
  layout->addSpacing(8);
  layout->addWidget(button, 0, Qt::AlignHCenter);
  layout->addStretch();
  addTab(page, tr("%1° missing").arg(axisDeg));
}

/// Shows a tab for each missing position, behind the tabs of the positions, and hides it otherwise.
void PositionTabs::showMissing() {
  for (int i = 0; i < 2; ++i) {
    const int tab = static_cast<int>(m_tables.size()) + i;
    const bool missing = !hasPosition(m_document.session(), axes[i]);
    if (isTabVisible(tab) != missing) setTabVisible(tab, missing);
  }
}

QWidget* PositionTabs::createPage(std::size_t position) {
  auto* table = new ReadingsTable(m_document, position);
  table->setObjectName(QStringLiteral("readings%1").arg(position));
  for (const auto& [column, shown] : m_shown) table->setColumnShown(column, shown);
  connect(table, &ReadingsTable::rowEntered, this,
          [this, position](std::size_t row) { emit rowEntered(position, row); });
  connect(table, &ReadingsTable::remark, this, &PositionTabs::remark);
  m_tables.push_back(table);

  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(6, 6, 6, 6);
  auto* zero = new ZeroEntries(m_document, position);
  zero->showFurther(m_showsZeros);
  connect(zero, &ZeroEntries::furtherWanted, this, &PositionTabs::showFurtherZeros);
  connect(zero, &ZeroEntries::entered, this, &PositionTabs::zeroEntered);
  m_zeros.push_back(zero);
  layout->addWidget(zero);
  layout->addWidget(table, 1);
  return page;
}

/// Shows or hides the further sightings of the zero in all positions together.
void PositionTabs::showFurtherZeros(bool shown) {
  m_showsZeros = shown;
  for (ZeroEntries* zero : m_zeros) zero->showFurther(shown);
}

/// Shows the further sightings of the zero if the session has any.
void PositionTabs::followZeros() {
  if (!m_showsZeros && std::ranges::any_of(m_zeros, &ZeroEntries::hasFurther)) showFurtherZeros(true);
}

void PositionTabs::nameTabs() {
  const auto& positions = m_document.session().positions;
  for (int tab = 0; tab < static_cast<int>(positions.size()); ++tab) {
    const QString position = positionText(m_document.session(), static_cast<std::size_t>(tab));
    const bool isFirst = position == positionText(0) || position == positionText(180);
    const bool isAgain = !isFirst && axisEntry(positions[static_cast<std::size_t>(tab)].axisDeg);
    const QString name = isAgain ? position  // short, so that the tabs of five positions fit
                                 : tr("Axis at %1").arg(menuText(position));
    if (tabText(tab) != name) setTabText(tab, name);
    const auto axis = axisEntry(positions[static_cast<std::size_t>(tab)].axisDeg);
    setTabToolTip(tab, axis ? tr("Alt+%1 goes to its readings").arg(*axis == 0 ? 0 : 1) : QString());
  }
}

ReadingsTable* PositionTabs::table(std::size_t position) const {
  return position < m_tables.size() ? m_tables[position] : nullptr;
}

ReadingsTable* PositionTabs::currentTable() const {
  return currentIndex() < 0 ? nullptr : table(static_cast<std::size_t>(currentIndex()));
}

void PositionTabs::setEvaluation(const SharedEvaluation& evaluation) {
  m_watch->setEvaluation(evaluation);
  for (ReadingsTable* table : m_tables) table->readings().setEvaluation(evaluation);
  for (ZeroEntries* zero : m_zeros) zero->setEvaluation(*evaluation);
  for (int tab = 0; tab < static_cast<int>(m_tables.size()); ++tab) {
    const auto& problems = evaluation->examined.problems;
    const bool wrong = std::any_of(problems.begin(), problems.end(), [&](const Problem& problem) {
      return problem.where.position == static_cast<std::size_t>(tab) &&
             !isMissing(evaluation->session, problem.where);
    });
    markTab(*this, tab, wrong);
  }
}

void PositionTabs::setColumnShown(ReadingColumn column, bool shown) {
  m_shown[column] = shown;
  for (ReadingsTable* table : m_tables) table->setColumnShown(column, shown);
}

void PositionTabs::showPosition(std::size_t position) {
  for (int tab = static_cast<int>(position); tab < count(); ++tab) {
    if (isTabVisible(tab)) return setCurrentIndex(tab);
  }
}

void PositionTabs::uncover(const Place& place) {
  if (place.field.starts_with("pointing_zero.") &&
      std::ranges::count(place.field, '.') > 1)  // not the first sighting
    showFurtherZeros(true);
}

void PositionTabs::selectCell(std::size_t position, std::size_t row, ReadingColumn column) {
  if (position >= m_tables.size()) return;
  setCurrentIndex(static_cast<int>(position));
  m_tables[position]->selectCell(static_cast<int>(row), column);
}

}  // namespace alidade::ui
