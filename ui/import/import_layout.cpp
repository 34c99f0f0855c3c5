#include "ui/import/import_layout.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/panels/parts/dialog_parts.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

QLabel* labelFor(const QString& text, QWidget* field) {
  auto* label = new QLabel(text);
  label->setBuddy(field);
  return label;
}

using Columns = std::vector<std::size_t>;

QString dataOf(const Columns& columns) {
  QStringList numbers;
  for (const std::size_t column : columns) numbers.append(QString::number(column));
  return numbers.join(u',');
}

Columns columnsOf(const QString& data) {
  Columns columns;
  for (const QString& number : data.split(u',', Qt::SkipEmptyParts)) columns.push_back(number.toULongLong());
  return columns;
}

/// The column key of one part of an angle: "horizontal", "horizontal_minutes".
std::string partKey(const std::string& key, std::size_t part) {
  auto column = tableColumn(key);
  if (column) column->part = static_cast<AnglePart>(part);
  return column ? column->key() : key;
}

bool isOfAngle(const std::string& key) {
  const auto column = tableColumn(key);
  return column && column->field && isAngle(*column->field);
}

/// The columns with this key and, for an angle, the columns of its minutes and seconds; empty if none.
Columns heldBy(const TableLayout& layout, const std::string& key) {
  Columns held;
  for (std::size_t part = 0; part < (isOfAngle(key) ? 3U : 1U); ++part) {
    const auto found = std::ranges::find(layout.columns, partKey(key, part));
    if (found == layout.columns.end()) break;
    held.push_back(static_cast<std::size_t>(found - layout.columns.begin()));
  }
  return held;
}

void put(TableLayout& layout, const std::string& key, const Columns& columns) {
  for (std::size_t part = 0; part < columns.size(); ++part)
    layout.columns.at(columns[part]) = partKey(key, part);
}

/// Lets the box be narrower than its texts, since three boxes share a row.
void narrow(QComboBox& box) {
  box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box.setMinimumContentsLength(7);
}

}  // namespace

ImportLayout::ImportLayout()
    : m_reasons(createPlainLabel({})),
      m_table(new QWidget),
      m_unit(new QComboBox),
      m_decimalSign(new QComboBox),
      m_headRows(new QSpinBox) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_reasons);
  layout->addWidget(m_table);
  layout->addStretch(1);
  auto* grid = new QGridLayout(m_table);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(createForm(), 0, 0, 1, 6);
  grid->addWidget(new QLabel(tr("Columns of the file:")), 1, 0, 1, 6);
  addRole(*grid, "axis", tr("P&osition:"));
  addRole(*grid, "point", tr("&Point:"));
  addRole(*grid, "round", tr("&Round:"));
  addRole(*grid, "face", tr("&Face:"));
  addRole(*grid, "horizontal", tr("&Horizontal:"));
  addRole(*grid, "vertical", tr("&Vertical:"));
  addRole(*grid, "slider", tr("&Slider:"));
  addRole(*grid, "horizontal_2", tr("Horizontal, &2nd face:"));
  addRole(*grid, "vertical_2", tr("Vertical, 2nd fa&ce:"));
  addRole(*grid, "excluded", tr("E&xcluded:"));
  addRole(*grid, "note", tr("&Note:"));
  for (const int column : {1, 3, 5}) grid->setColumnStretch(column, 1);
}

QWidget* ImportLayout::createForm() {
  m_unit->setObjectName(QStringLiteral("import unit"));
  m_unit->addItem(tr("As written"), static_cast<int>(AngleUnit::Unstated));
  m_unit->addItem(tr("Decimal degrees"), static_cast<int>(AngleUnit::Degrees));
  m_unit->addItem(tr("Gon"), static_cast<int>(AngleUnit::Gon));
  m_unit->addItem(tr("Degrees.minutes seconds"), static_cast<int>(AngleUnit::Dms));
  m_unit->setToolTip(
      tr("Unit of the numbers in columns that state no unit. In degrees.minutes seconds, 341.5224 is "
         "341°52′24″"));
  m_decimalSign->addItem(tr("Either"), static_cast<int>(DecimalSign::Either));
  m_decimalSign->addItem(tr("Point"), static_cast<int>(DecimalSign::Point));
  m_decimalSign->addItem(tr("Comma"), static_cast<int>(DecimalSign::Comma));
  m_headRows->setRange(0, 1000);
  m_headRows->setObjectName(QStringLiteral("import head rows"));
  m_headRows->setToolTip(tr("The last of these rows has the column names"));
  auto* form = new QWidget;
  auto* row = new QHBoxLayout(form);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [row](const QString& label, QWidget* field, int stretch) {
    row->addWidget(labelFor(label, field));
    row->addWidget(field, stretch);
  };
  add(tr("&Unit:"), m_unit, 2);
  add(tr("&Decimals:"), m_decimalSign, 1);
  add(tr("Rows &before:"), m_headRows, 0);
  connect(m_unit, &QComboBox::currentIndexChanged, this, &ImportLayout::take);
  connect(m_decimalSign, &QComboBox::currentIndexChanged, this, &ImportLayout::take);
  connect(m_headRows, &QSpinBox::valueChanged, this, &ImportLayout::take);
  return form;
}

void ImportLayout::addRole(QGridLayout& grid, const std::string& key, const QString& label) {
  constexpr int across = 3, rolesAt = 2;
  auto* box = new QComboBox;
  box->setObjectName(QStringLiteral("import ") + qText(key));
  narrow(*box);
  const int at = static_cast<int>(m_roles.size());
  QLabel* name = labelFor(label, box);
  grid.addWidget(name, rolesAt + at / across, 2 * (at % across));
  grid.addWidget(box, rolesAt + at / across, 2 * (at % across) + 1);
  m_roles.push_back({key, name, box});
  connect(box, &QComboBox::currentIndexChanged, this, &ImportLayout::take);
}

void ImportLayout::fillColumns(const ImportSource& source) {
  for (const Role& role : m_roles) {
    fillRole(role, source);
    const bool isOfFaceTwo = role.key.ends_with("_2");
    role.label->setVisible(!isOfFaceTwo || !heldBy(m_layout, role.key).empty());
    role.column->setVisible(!isOfFaceTwo || !heldBy(m_layout, role.key).empty());
  }
}

/// Lists each column, and groups of columns that form one angle.
void ImportLayout::fillRole(const Role& role, const ImportSource& source) const {
  role.column->clear();
  role.column->addItem(tr("none"), QString());
  const Columns held = heldBy(m_layout, role.key);
  for (std::size_t i = 0; i < m_layout.columns.size(); ++i) {
    addChoice(role, source, {i});
    if (!isOfAngle(role.key)) continue;
    for (const JoinableColumns& joinable : source.recognised.joinable) {
      if (joinable.first != i || i + joinable.count > m_layout.columns.size()) continue;
      Columns columns;
      for (std::size_t k = 0; k < joinable.count; ++k) columns.push_back(i + k);
      addChoice(role, source, columns);
    }
  }
  if (role.column->findData(dataOf(held)) < 0) addChoice(role, source, held);
  role.column->setCurrentIndex(role.column->findData(dataOf(held)));
}

/// Adds a choice such as `2: Hz`, `2–4: Hz deg, Hz min, Hz sec` or `column 2`.
void ImportLayout::addChoice(const Role& role, const ImportSource& source, const Columns& columns) const {
  const std::vector<std::string>& titles = source.recognised.titles;
  QStringList names, numbers;
  for (const std::size_t i : columns) {
    numbers.append(QString::number(i + 1));
    if (i < titles.size() && !titles[i].empty()) names.append(QString::fromStdString(titles[i]));
  }
  const bool areInTurn = columns.size() > 1 && columns.back() - columns.front() + 1 == columns.size();
  const QString number =
      areInTurn ? numbers.first() + QStringLiteral("–") + numbers.last() : numbers.join(u'+');
  const QString unnamed = columns.size() > 1 ? tr("columns %1").arg(number) : tr("column %1").arg(number);
  const QString text =
      names.isEmpty() ? unnamed : number + QStringLiteral(": ") + shortLine(listText(names), 40);
  role.column->addItem(text, dataOf(columns));
}

void ImportLayout::show(const ImportSource& source, const TableLayout& layout, bool isRemembered) {
  m_isFilling = true;
  m_layout = layout;
  QStringList reasons;
  for (const std::string& reason : source.recognised.reasons) reasons.append(visibleLine(reason));
  QString text = capitalised(reasons.join(QStringLiteral("; "))) + u'.';
  if (isRemembered) text += u' ' + tr("The settings below are those you last used for this layout.");
  m_reasons->setText(text);
  const bool isTable = source.recognised.isTable();
  m_table->setVisible(isTable);
  m_unit->setCurrentIndex(m_unit->findData(static_cast<int>(layout.unit)));
  m_decimalSign->setCurrentIndex(m_decimalSign->findData(static_cast<int>(layout.decimalSign)));
  m_headRows->setValue(static_cast<int>(layout.headRows));
  fillColumns(source);
  m_isFilling = false;
}

/// Reads the choices. A column has one role; the choice made last prevails.
void ImportLayout::take() {
  if (m_isFilling) return;
  TableLayout layout = m_layout;
  layout.unit = static_cast<AngleUnit>(m_unit->currentData().toInt());
  layout.decimalSign = static_cast<DecimalSign>(m_decimalSign->currentData().toInt());
  layout.headRows = static_cast<std::size_t>(m_headRows->value());
  std::fill(layout.columns.begin(), layout.columns.end(), std::string());
  const auto choose = [&layout](const Role& role) {
    put(layout, role.key, columnsOf(role.column->currentData().toString()));
  };
  for (const Role& role : m_roles) choose(role);
  for (const Role& role : m_roles)
    if (role.column == sender()) choose(role);
  m_isFilling = true;
  for (const Role& role : m_roles) {
    const Columns chosen = columnsOf(role.column->currentData().toString());
    if (heldBy(layout, role.key) == chosen) continue;
    for (std::size_t part = 0; part < chosen.size(); ++part)  // the role also loses its other columns
      if (layout.columns[chosen[part]] == partKey(role.key, part)) layout.columns[chosen[part]].clear();
    role.column->setCurrentIndex(0);
  }
  m_isFilling = false;
  if (layout == m_layout) return;
  m_layout = layout;
  emit chosen();
}

}  // namespace alidade::ui
