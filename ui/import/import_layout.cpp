#include "ui/import/import_layout.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/dialogs/plain_label.h"
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

/// As wide as there is room: three stand in a row.
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
  m_unit->setToolTip(tr(
      "Of plain numbers in columns that name no unit. With degrees.minutes seconds 341.5224 is 341°52′24″"));
  m_decimalSign->addItem(tr("Either"), static_cast<int>(DecimalSign::Either));
  m_decimalSign->addItem(tr("Point"), static_cast<int>(DecimalSign::Point));
  m_decimalSign->addItem(tr("Comma"), static_cast<int>(DecimalSign::Comma));
  m_headRows->setRange(0, 1000);
  m_headRows->setObjectName(QStringLiteral("import head rows"));
  m_headRows->setToolTip(tr("The last of them names the columns"));
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
  grid.addWidget(labelFor(label, box), rolesAt + at / across, 2 * (at % across));
  grid.addWidget(box, rolesAt + at / across, 2 * (at % across) + 1);
  m_roles.push_back({key, box});
  connect(box, &QComboBox::currentIndexChanged, this, &ImportLayout::take);
}

void ImportLayout::fillColumns(const ImportSource& source) {
  const std::vector<std::string>& titles = source.recognised.titles;
  for (const Role& role : m_roles) {
    role.column->clear();
    role.column->addItem(tr("none"), -1);
    for (std::size_t i = 0; i < m_layout.columns.size(); ++i) {
      const QString number = QString::number(i + 1);
      const bool isNamed = i < titles.size() && !titles[i].empty();
      role.column->addItem(
          isNamed ? number + QStringLiteral(": ") + shortLine(titles[i], 40) : tr("column %1").arg(number),
          static_cast<int>(i));
      if (m_layout.columns[i] == role.key) role.column->setCurrentIndex(role.column->count() - 1);
    }
  }
}

void ImportLayout::show(const ImportSource& source, const TableLayout& layout, bool isRemembered) {
  m_isFilling = true;
  m_layout = layout;
  QStringList reasons;
  for (const std::string& reason : source.recognised.reasons) reasons.append(visibleLine(reason));
  QString text = capitalised(reasons.join(QStringLiteral("; "))) + u'.';
  if (isRemembered) text += u' ' + tr("Below it stands as you took such a file the last time.");
  m_reasons->setText(text);
  const bool isTable = source.recognised.isTable();
  m_table->setVisible(isTable);
  m_unit->setCurrentIndex(m_unit->findData(static_cast<int>(layout.unit)));
  m_decimalSign->setCurrentIndex(m_decimalSign->findData(static_cast<int>(layout.decimalSign)));
  m_headRows->setValue(static_cast<int>(layout.headRows));
  fillColumns(source);
  m_isFilling = false;
}

/// A column holds one thing: what is chosen last counts.
void ImportLayout::take() {
  if (m_isFilling) return;
  TableLayout layout = m_layout;
  layout.unit = static_cast<AngleUnit>(m_unit->currentData().toInt());
  layout.decimalSign = static_cast<DecimalSign>(m_decimalSign->currentData().toInt());
  layout.headRows = static_cast<std::size_t>(m_headRows->value());
  std::fill(layout.columns.begin(), layout.columns.end(), std::string());
  const auto put = [&layout](const Role& role) {
    const int column = role.column->currentData().toInt();
    if (column >= 0) layout.columns[static_cast<std::size_t>(column)] = role.key;
  };
  for (const Role& role : m_roles) put(role);
  for (const Role& role : m_roles)
    if (role.column == sender()) put(role);
  m_isFilling = true;
  for (const Role& role : m_roles) {
    const auto found = std::find(layout.columns.begin(), layout.columns.end(), role.key);
    const bool isThere = found != layout.columns.end();
    role.column->setCurrentIndex(isThere ? static_cast<int>(found - layout.columns.begin()) + 1 : 0);
  }
  m_isFilling = false;
  if (layout == m_layout) return;
  m_layout = layout;
  emit chosen();
}

}  // namespace alidade::ui
