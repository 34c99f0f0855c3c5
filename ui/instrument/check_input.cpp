#include "ui/instrument/check_input.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/in_background.h"
#include "ui/import/import_source.h"
#include "ui/instrument/check_rows_draft.h"
#include "ui/instrument/check_rows_table.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

QDoubleSpinBox* sigmaBox() {
  auto* box = new QDoubleSpinBox;
  box->setDecimals(2);
  box->setRange(0, 999);
  box->setSingleStep(0.5);
  box->setSuffix(QStringLiteral("″"));
  box->setSpecialValueText(CheckInput::tr("not stated"));
  box->setKeyboardTracking(false);
  box->setToolTip(CheckInput::tr(
      "σ of a value observed once in both faces, as in a data sheet according to ISO 17123-3"));
  return box;
}

std::optional<double> statedOf(const QDoubleSpinBox& box) {
  return box.value() > 0 ? std::optional(box.value()) : std::nullopt;
}

}  // namespace

CheckInput::CheckInput(Dialogs& dialogs, QWidget* parent)
    : QWidget(parent), m_dialogs(dialogs), m_tabs(new QTabWidget), m_table(new CheckRowsTable) {
  m_tabs->addTab(createFiles(), tr("&Files"));
  m_tabs->addTab(createRows(), tr("&Rows Typed"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_tabs, 1);
  layout->addWidget(createIdentity(), 0);
  layout->addWidget(createForm(), 0);
  connect(&m_table->rows(), &CheckRowsModel::edited, this, &CheckInput::changed);
  for (QDoubleSpinBox* box : {m_sigmaDirection, m_sigmaVertical})
    connect(box, &QDoubleSpinBox::valueChanged, this, &CheckInput::changed);
  for (QComboBox* box : {m_unit, m_circle})
    connect(box, &QComboBox::currentIndexChanged, this, &CheckInput::changed);
  if (!m_table->rows().isBlank()) m_tabs->setCurrentIndex(1);
  showButtons();
}

QWidget* CheckInput::createFiles() {
  m_list = new QListWidget;
  m_list->setAccessibleName(tr("Files of readings"));
  m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_add = new QPushButton(tr("&Open Files…"));
  m_add->setObjectName(QStringLiteral("open check files"));
  m_remove = new QPushButton(tr("R&emove"));
  auto* files = new QWidget;
  auto* layout = new QHBoxLayout(files);
  layout->addWidget(m_list, 1);
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(m_add);
  buttons->addWidget(m_remove);
  buttons->addStretch();
  layout->addLayout(buttons);
  connect(m_add, &QPushButton::clicked, this, &CheckInput::chooseFiles);
  connect(m_remove, &QPushButton::clicked, this, &CheckInput::removeFiles);
  connect(m_list, &QListWidget::itemSelectionChanged, this, &CheckInput::showButtons);
  return files;
}

/// Creates the table of rows, which restores the rows of an earlier window.
QWidget* CheckInput::createRows() {
  new CheckRowsDraft(*m_table);
  m_clear = new QPushButton;
  m_clear->setObjectName(QStringLiteral("clear check rows"));
  m_clear->setToolTip(tr("The rows stay until they are cleared, even when the program ends"));
  auto* rows = new QWidget;
  auto* layout = new QHBoxLayout(rows);
  layout->addWidget(m_table, 1);
  layout->addWidget(m_clear, 0, Qt::AlignTop);
  connect(m_table, &EntryTable::remark, this,
          [this](const QString& text) { m_dialogs.showProblem(tr("Instrument check"), text); });
  connect(m_clear, &QPushButton::clicked, this, &CheckInput::clearRows);
  connect(&m_table->rows(), &CheckRowsModel::edited, this, &CheckInput::showButtons);
  return rows;
}

QWidget* CheckInput::createForm() {
  m_sigmaDirection = sigmaBox();
  m_sigmaVertical = sigmaBox();
  m_unit = new QComboBox;
  m_unit->addItem(tr("found from the two faces"), static_cast<int>(AngleUnit::Unstated));
  m_unit->addItem(tr("decimal degrees"), static_cast<int>(AngleUnit::Degrees));
  m_unit->addItem(tr("gon"), static_cast<int>(AngleUnit::Gon));
  m_unit->addItem(tr("degrees.minutes seconds"), static_cast<int>(AngleUnit::Dms));
  m_circle = new QComboBox;
  m_circle->addItem(tr("from the readings"), QString());
  m_circle->addItem(tr("zenith angles"), QStringLiteral("zenith"));
  m_circle->addItem(tr("elevations"), QStringLiteral("elevation"));
  for (QComboBox* box : {m_unit, m_circle}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(16);
  }
  auto* widget = new QWidget;
  auto* form = new QFormLayout(widget);
  form->setContentsMargins(8, 4, 0, 0);
  form->addRow(tr("σ of a &direction:"), m_sigmaDirection);
  form->addRow(tr("σ of a &zenith angle:"), m_sigmaVertical);
  form->addRow(tr("&Plain numbers:"), m_unit);
  form->addRow(tr("&Vertical circle:"), m_circle);
  return widget;
}

QWidget* CheckInput::createIdentity() {
  auto* widget = new QWidget;
  auto* form = new QFormLayout(widget);
  form->setContentsMargins(8, 4, 0, 0);
  const auto add = [&](const QString& label, const char* name, const QString& tip) {
    auto* line = new QLineEdit;
    line->setObjectName(QString::fromLatin1(name));
    line->setToolTip(tip);
    line->setMaximumWidth(fontMetrics().averageCharWidth() * 20);
    connect(line, &QLineEdit::editingFinished, this, &CheckInput::changed);
    form->addRow(label, line);
    return line;
  };
  m_name = add(tr("&Instrument:"), "check name", tr("Its name or model, for the record and the report"));
  m_serial =
      add(tr("Serial &number:"), "check serial", tr("Identifies the instrument in sessions and histories"));
  m_date = add(tr("C&hecked on:"), "check date", tr("Year-month-day"));
  m_due = add(tr("Next check d&ue:"), "check due", tr("Year-month-day; kept in the instrument record"));
  suggest({});
  return widget;
}

void CheckInput::suggest(const CheckIdentity& read) {
  const auto show = [](QLineEdit* line, const std::string& text) {
    line->setPlaceholderText(text.empty() ? tr("not stated") : visibleLine(text));
  };
  show(m_name, read.name);
  show(m_serial, read.serial);
  show(m_date, read.measuredOn);
  show(m_due, {});
}

void CheckInput::chooseFiles() {
  const QString folder = m_files.empty() ? QString() : QFileInfo(m_files.back().path).absolutePath();
  addFiles(m_dialogs.askImportPaths(folder));
}

void CheckInput::addFiles(const QStringList& paths) {
  if (paths.isEmpty()) return;
  const auto sources = inBackground<Result<std::vector<ImportSource>>>(
      *m_dialogs.busy(tr("Reading the files…")),
      [paths](const std::stop_token&) { return readSources(paths); });
  if (!sources) return;
  if (!*sources) return m_dialogs.showProblem(tr("Instrument check"), visibleLine(sources->problem().text()));
  for (std::size_t i = 0; i < (*sources)->size(); ++i) {
    const ImportSource& source = (**sources)[i];
    m_files.push_back({paths.value(static_cast<int>(i)), source.name, source.bytes});
    m_list->addItem(visibleLine(source.name));
  }
  emit changed();
}

void CheckInput::removeFiles() {
  for (int row = m_list->count() - 1; row >= 0; --row)
    if (m_list->item(row)->isSelected()) {
      m_files.erase(m_files.begin() + row);
      delete m_list->takeItem(row);
    }
  showButtons();
  emit changed();
}

/// Clears all rows, or restores the last cleared ones.
void CheckInput::clearRows() {
  m_table->commitOpenEditor();
  CheckRowsModel& rows = m_table->rows();
  const ReadingBlock before = rows.block();
  rows.restore(m_cleared);
  m_cleared = before;
  showButtons();
}

void CheckInput::showButtons() {
  m_remove->setEnabled(!m_list->selectedItems().isEmpty());
  const bool isBlank = m_table->rows().isBlank();
  if (!isBlank) m_cleared.clear();
  m_clear->setText(isBlank && !m_cleared.isEmpty() ? tr("Bring &Back") : tr("C&lear"));
  m_clear->setEnabled(!isBlank || !m_cleared.isEmpty());
}

QStringList CheckInput::paths() const {
  QStringList paths;
  for (const OpenFile& file : m_files) paths.append(file.path);
  return paths;
}

InstrumentQuestion CheckInput::question() const {
  InstrumentQuestion question;
  for (const OpenFile& file : m_files) question.sources.push_back({file.name.toStdString(), file.bytes});
  const CheckRowsModel& rows = m_table->rows();
  if (!rows.isEmpty())
    question.sources.push_back({tr("typed").toStdString(), std::make_shared<const std::string>(rows.csv()),
                                CheckRowsModel::layout()});
  question.reading.unit = static_cast<AngleUnit>(m_unit->currentData().toInt());
  question.reading.verticalCircle = m_circle->currentData().toString().toStdString();
  const auto typed = [](const QLineEdit* line) { return line->text().trimmed().toStdString(); };
  question.identity = {
      .name = typed(m_name), .serial = typed(m_serial), .measuredOn = typed(m_date), .due = typed(m_due)};
  question.stated.sigmaDirection = statedOf(*m_sigmaDirection);
  question.stated.sigmaVertical = statedOf(*m_sigmaVertical);
  return question;
}

}  // namespace alidade::ui
