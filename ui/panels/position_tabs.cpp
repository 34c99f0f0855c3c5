#include "ui/panels/position_tabs.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/document/session_document.h"
#include "ui/forms/field_edit.h"
#include "ui/panels/findings_panel.h"
#include "ui/panels/readings_table.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

PositionTabs::PositionTabs(SessionDocument& document, QWidget* parent)
    : QTabWidget(parent), m_document(document) {
  setDocumentMode(false);
  connect(&document, &SessionDocument::aboutToChange, this, [this](const SessionChange& change) {
    if (change.kind != SessionChange::Kind::Everything) return;
    m_tables.clear();
    while (count() > 0) delete widget(0);
  });
  connect(&document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    if (change.kind == SessionChange::Kind::Everything) rebuild();
    if (change.kind == SessionChange::Kind::Field) nameTabs();
  });
  rebuild();
}

void PositionTabs::rebuild() {
  for (std::size_t position = 0; position < m_document.session().positions.size(); ++position) {
    addTab(createPage(position), QString());
  }
  nameTabs();
  for (ReadingsTable* table : m_tables) emit tableCreated(table);
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
  layout->addWidget(createZeroEntries(position));
  layout->addWidget(table, 1);
  return page;
}

QWidget* PositionTabs::createZeroEntries(std::size_t position) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const char* field, const QString& caption, const QString& spoken, const QString& hint,
                       FieldEdit::Shows shows) {
    auto* entry = new FieldEdit(m_document, {.position = position, .field = field}, shows);
    entry->setObjectName(QStringLiteral("%1 %2").arg(QString::fromLatin1(field)).arg(position));
    entry->setAccessibleName(spoken);
    entry->setHint(hint);
    auto* label = new QLabel(caption);
    label->setBuddy(entry);
    layout->addWidget(label);
    layout->addWidget(entry, shows == FieldEdit::Shows::Angle ? 1 : 0);
    return entry;
  };
  add("pointing_zero.horizontal", tr("&α0"), tr("Pointing zero, horizontal"),
      tr("Horizontal circle reading of the direction perpendicular to the plane of the arc"),
      FieldEdit::Shows::Angle)
      ->setPlaceholderText(tr("required"));
  layout->addSpacing(6);
  add("pointing_zero.vertical", tr("&β0"), tr("Pointing zero, vertical"),
      tr("Vertical circle reading of the direction perpendicular to the plane of the arc"),
      FieldEdit::Shows::Angle)
      ->setPlaceholderText(tr("required"));
  layout->addSpacing(6);
  FieldEdit* axis = add("axis_deg", tr("A&xis"), tr("Position of the axis in degrees"),
                        tr("Rotation of the axis: 0 or 180 degrees"), FieldEdit::Shows::AsTyped);
  axis->setFixedWidth(56);
  layout->addWidget(new QLabel(tr("°")));
  return row;
}

void PositionTabs::nameTabs() {
  const auto& positions = m_document.session().positions;
  for (int tab = 0; tab < count(); ++tab) {
    const std::string& axis = positions.at(static_cast<std::size_t>(tab)).axisDeg;
    const QString name = axis == "0"     ? tr("Axis at &0°")
                         : axis == "180" ? tr("Axis at &180°")
                                         : tr("Axis at %1°").arg(qText(axis));
    if (tabText(tab) != name) setTabText(tab, name);
  }
}

ReadingsTable* PositionTabs::table(std::size_t position) const {
  return position < m_tables.size() ? m_tables[position] : nullptr;
}

ReadingsTable* PositionTabs::currentTable() const {
  return currentIndex() < 0 ? nullptr : table(static_cast<std::size_t>(currentIndex()));
}

void PositionTabs::setEvaluation(const Evaluation& evaluation) {
  for (ReadingsTable* table : m_tables) table->readings().setEvaluation(evaluation);
  for (int tab = 0; tab < count(); ++tab) {
    const auto& problems = evaluation.examined.problems;
    const bool wrong = std::any_of(problems.begin(), problems.end(), [&](const Problem& problem) {
      return problem.where.position == static_cast<std::size_t>(tab) &&
             !isMissing(evaluation.session, problem.where);
    });
    markTab(*this, tab, wrong);
  }
}

void PositionTabs::setColumnShown(ReadingColumn column, bool shown) {
  m_shown[column] = shown;
  for (ReadingsTable* table : m_tables) table->setColumnShown(column, shown);
}

void PositionTabs::selectCell(std::size_t position, std::size_t row, ReadingColumn column) {
  if (position >= m_tables.size()) return;
  setCurrentIndex(static_cast<int>(position));
  m_tables[position]->selectCell(static_cast<int>(row), column);
}

}  // namespace alidade::ui
