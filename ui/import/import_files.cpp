#include "ui/import/import_files.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSpinBox>
#include <algorithm>
#include <limits>

#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

enum Column { FileColumn, KindColumn, WhereColumn, TurnedColumn, RoundColumn, columnTotal };

using Where = FileChoice::Where;

/// Puts a cell widget into a frame: a view shows its cell widgets again, even those that were hidden.
QWidget* framed(QWidget* content) {
  auto* frame = new QWidget;
  auto* layout = new QHBoxLayout(frame);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(content);
  return frame;
}

/// The role of the axis angle in the items of the position list.
constexpr int axisRole = Qt::UserRole + 1;

}  // namespace

ImportFiles::ImportFiles(const std::vector<ImportSource>& sources, const std::vector<FileChoice>& choices) {
  setColumnCount(columnTotal);
  setHorizontalHeaderLabels({tr("File"), tr("Read as"), tr("Position"), tr("180° from line"), tr("Round")});
  setObjectName(QStringLiteral("import files"));
  setAccessibleName(tr("Files to import"));
  setSelectionBehavior(SelectRows);
  setSelectionMode(sources.size() > 1 ? SingleSelection : NoSelection);
  setEditTriggers(NoEditTriggers);
  setTabKeyNavigation(false);
  verticalHeader()->hide();
  for (std::size_t i = 0; i < sources.size(); ++i) addRow(sources[i], choices[i]);
  fitColumns();
  selectRow(0);
  constexpr int mostShown = 4;
  const int shown = std::clamp(rowCount(), 1, mostShown);
  setFixedHeight(horizontalHeader()->sizeHint().height() + shown * rowHeight(0) + 2 * frameWidth());
}

void ImportFiles::fitColumns() {
  QHeaderView* header = horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(FileColumn, QHeaderView::Stretch);
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void ImportFiles::addRow(const ImportSource& source, const FileChoice& choice) {
  const int row = rowCount();
  insertRow(row);
  auto* name = new QTableWidgetItem(shortLine(source.name, 60));
  name->setToolTip(tipText(source.name));
  setItem(row, FileColumn, name);
  setItem(row, KindColumn, new QTableWidgetItem(qText(source.recognised.name)));
  QComboBox* where = createWhere(source, choice);
  auto* turned = new QSpinBox;
  turned->setRange(1, std::numeric_limits<int>::max());
  turned->setValue(static_cast<int>(std::max<std::size_t>(choice.turnedAtLine, 1)));
  turned->setAccessibleName(tr("180° from this line of “%1” on").arg(visibleLine(source.name)));
  QComboBox* round = createRound(choice);
  where->setAccessibleName(tr("Position of “%1”").arg(visibleLine(source.name)));
  round->setAccessibleName(tr("Round of “%1”").arg(visibleLine(source.name)));
  setCellWidget(row, WhereColumn, where);
  setCellWidget(row, TurnedColumn, framed(turned));
  setCellWidget(row, RoundColumn, round);
  setRowHeight(row, where->sizeHint().height() + 2);
  m_rows.push_back({where, turned, round});
  const auto changed = [this, where, turned, row] {
    turned->setVisible(where->currentData().toInt() == static_cast<int>(Where::Turned));
    setCurrentCell(row, FileColumn);
    emit chosen();
  };
  turned->setVisible(choice.where == Where::Turned);
  connect(where, &QComboBox::currentIndexChanged, this, changed);
  connect(round, &QComboBox::currentIndexChanged, this, changed);
  connect(turned, &QSpinBox::valueChanged, this, changed);
}

QComboBox* ImportFiles::createWhere(const ImportSource& source, const FileChoice& choice) {
  auto* box = new QComboBox;
  const auto add = [box](const QString& text, Where where, const char* axis = "") {
    box->addItem(text, static_cast<int>(where));
    box->setItemData(box->count() - 1, QString::fromLatin1(axis), axisRole);
  };
  if (source.recognised.saysAxis)
    add(tr("As the file says"), Where::ByLine);
  else
    add(tr("Choose…"), Where::Unknown);
  add(tr("All at 0°"), Where::All, "0");
  add(tr("All at 180°"), Where::All, "180");
  if (!source.recognised.saysAxis) add(tr("0°, then 180°"), Where::Turned);
  for (int i = 0; i < box->count(); ++i)
    if (box->itemData(i).toInt() == static_cast<int>(choice.where) &&
        box->itemData(i, axisRole).toString() == qText(choice.axis))
      box->setCurrentIndex(i);
  return box;
}

QComboBox* ImportFiles::createRound(const FileChoice& choice) {
  constexpr int most = 20;
  auto* box = new QComboBox;
  box->addItem(tr("As the file says"), QString());
  for (int round = 1; round <= most; ++round) box->addItem(QString::number(round), QString::number(round));
  const int at = box->findData(qText(choice.round));
  box->setCurrentIndex(std::max(at, 0));
  return box;
}

std::vector<FileChoice> ImportFiles::choices() const {
  std::vector<FileChoice> choices;
  for (const Row& row : m_rows) {
    FileChoice choice;
    choice.where = static_cast<Where>(row.where->currentData().toInt());
    choice.axis = row.where->currentData(axisRole).toString().toStdString();
    choice.round = row.round->currentData().toString().toStdString();
    if (choice.where == Where::Turned) choice.turnedAtLine = static_cast<std::size_t>(row.turned->value());
    choices.push_back(choice);
  }
  return choices;
}

void ImportFiles::focusOpenChoice() {
  const auto open = std::find_if(m_rows.begin(), m_rows.end(), [](const Row& row) {
    return row.where->currentData().toInt() == static_cast<int>(Where::Unknown);
  });
  (open == m_rows.end() ? m_rows.front() : *open).where->setFocus();
}

std::size_t ImportFiles::current() const {
  return static_cast<std::size_t>(std::max(currentRow(), 0));
}

}  // namespace alidade::ui
