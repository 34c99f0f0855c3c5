#include "ui/series/record_history_dialog.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/clock.h"
#include "core/series/history/history_json.h"
#include "core/series/history/history_sentences.h"
#include "core/series/history/history_statement.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/written_file.h"
#include "ui/document/encoded_path.h"
#include "ui/panels/parts/dialog_parts.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/frames.h"
#include "ui/panels/parts/statement_table.h"
#include "ui/series/history_chart.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

RecordHistoryDialog::RecordHistoryDialog(Dialogs& dialogs, QWidget* parent)
    : QDialog(parent),
      m_dialogs(dialogs),
      m_table(new StatementTable(recordTable({}, {}))),
      m_chart(new HistoryChart),
      m_says(wrappedLabel()),
      m_remarks(wrappedLabel()) {
  setWindowTitle(tr("Instrument Records over Time"));
  m_table->setAccessibleName(tr("Records of the instrument"));
  m_table->setPlaceholder(tr("Add a folder of instrument records (*.alidade-instrument)."));
  m_says->setObjectName(QStringLiteral("record history says"));
  m_says->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_remarks->setObjectName(QStringLiteral("record remarks"));
  auto* below = split(Qt::Horizontal, "record history parts", {m_chart, scrolled(m_says)}, {620, 340});
  auto* lower = new QWidget;
  auto* column = new QVBoxLayout(lower);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(createChoices());
  column->addWidget(below, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(split(Qt::Vertical, "record history", {m_table, lower}, {160, 400}), 1);
  layout->addWidget(m_remarks);
  layout->addWidget(createButtons());
  resize(980, 640);
  connect(m_instruments, &QComboBox::activated, this, &RecordHistoryDialog::showInstrument);
  connect(m_quantities, &QComboBox::activated, this, &RecordHistoryDialog::showQuantity);
  connect(m_baseline, &QSpinBox::valueChanged, this, &RecordHistoryDialog::showInstruments);
  connect(&m_chart->files(), &ChartFiles::fileWanted, this,
          [this](const ChartFile& file) { write(tr("Save chart"), file.suffix, file.bytes.toStdString()); });
  showInstruments();
}

QWidget* RecordHistoryDialog::createChoices() {
  m_instruments = new QComboBox;
  m_quantities = new QComboBox;
  m_baseline = new QSpinBox;
  m_instruments->setAccessibleName(tr("Instrument"));
  m_quantities->setAccessibleName(tr("Quantity"));
  m_baseline->setAccessibleName(tr("Records in the baseline"));
  m_baseline->setSpecialValueText(tr("all records"));
  m_baseline->setToolTip(tr("The first records set centre line and limits, which watch the later ones"));
  m_baseline->setKeyboardTracking(false);
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const QString& text, QWidget* choice) {
    auto* label = new QLabel(text);
    label->setBuddy(choice);
    layout->addWidget(label);
    layout->addWidget(choice);
    return label;
  };
  m_instrumentsLabel = add(tr("&Instrument"), m_instruments);
  add(tr("&Quantity"), m_quantities);
  add(tr("&Baseline"), m_baseline);
  for (QComboBox* choice : {m_instruments, m_quantities})
    choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  layout->addStretch();
  return row;
}

QWidget* RecordHistoryDialog::createButtons() {
  auto* row = new ButtonRow;
  QPushButton* folder = row->add(tr("Add &Folder…"), "add record folder");
  folder->setToolTip(tr("All instrument records (*.alidade-instrument) of a folder"));
  m_json = row->add(tr("Export &JSON…"), "export record history json");
  m_csv = row->add(tr("Export &CSV…"), "export record history csv");
  row->addRoom();
  QPushButton* close = row->add(tr("Close"), "close");
  connect(folder, &QPushButton::clicked, this, &RecordHistoryDialog::addFolder);
  connect(m_json, &QPushButton::clicked, this, &RecordHistoryDialog::exportJson);
  connect(m_csv, &QPushButton::clicked, this, &RecordHistoryDialog::exportCsv);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  return row;
}

void RecordHistoryDialog::addFolder() {
  const QString folder = m_dialogs.askFolder(tr("Add a folder of instrument records"), m_folder);
  if (folder.isEmpty()) return;
  m_folder = folder;
  const QStringList before = m_paths;
  add({folder});
  if (m_paths == before)
    m_dialogs.showProblem(tr("Add a folder"),
                          tr("%1 holds no other instrument record (*.alidade-instrument): choose another "
                             "folder.")
                              .arg(visibleLine(folder)));
}

void RecordHistoryDialog::add(const QStringList& filesAndFolders) {
  for (const QString& path : filesAndFolders) {
    if (!QFileInfo(path).isDir()) {
      read(path);
      continue;
    }
    const QDir folder(path, QStringLiteral("*.alidade-instrument"), QDir::Name, QDir::Files);
    for (const QFileInfo& file : folder.entryInfoList()) read(file.absoluteFilePath());
  }
  m_histories = instrumentHistories(m_records);
  std::size_t most = 0;
  for (const InstrumentHistory& one : m_histories.instruments) most = std::max(most, one.records.size());
  m_baseline->setMaximum(static_cast<int>(most));
  showInstruments();
}

void RecordHistoryDialog::read(const QString& path) {
  const QString file = QFileInfo(path).absoluteFilePath();
  if (m_paths.contains(file)) return;
  m_paths.append(file);
  const std::string name = QFileInfo(path).fileName().toStdString();
  if (const Result<InstrumentRecord> record = loadInstrumentRecord(encodedPath(file)))
    m_records.push_back({name, *record});
  else
    m_unusable.push_back(name + ": " + record.problem().text());
}

const InstrumentHistory* RecordHistoryDialog::instrument() const {
  const int index = m_instruments->currentIndex();
  return index >= 0 ? &m_histories.instruments[static_cast<std::size_t>(index)] : nullptr;
}

const QuantityHistory* RecordHistoryDialog::quantity() const {
  const InstrumentHistory* shown = instrument();
  const int index = m_quantities->currentIndex();
  return shown && index >= 0 ? &shown->quantities[static_cast<std::size_t>(index)] : nullptr;
}

/// Keeps the chosen instrument and quantity if they still exist.
void RecordHistoryDialog::showInstruments() {
  for (InstrumentHistory& one : m_histories.instruments)
    setBaseline(one, static_cast<std::size_t>(m_baseline->value()));
  const QString kept = m_instruments->currentText();
  m_instruments->clear();
  for (const InstrumentHistory& one : m_histories.instruments)
    m_instruments->addItem(menuText(qText(instrumentName(one))));
  m_instruments->setCurrentIndex(
      std::max(m_instruments->findText(kept), m_instruments->count() > 0 ? 0 : -1));
  for (QWidget* part : std::initializer_list<QWidget*>{m_instrumentsLabel, m_instruments})
    part->setVisible(m_instruments->count() > 1);
  m_baseline->setEnabled(m_baseline->maximum() > 1);
  m_json->setEnabled(m_instruments->count() > 0);
  showRemarks();
  showInstrument();
}

void RecordHistoryDialog::showInstrument() {
  const QVariant kept = m_quantities->currentData();
  m_quantities->clear();
  const InstrumentHistory* shown = instrument();
  m_table->setStatement(recordTable(shown ? *shown : InstrumentHistory(), localDay()));
  if (shown)
    for (const QuantityHistory& one : shown->quantities)
      m_quantities->addItem(qText(quantityName(one.id)), qText(one.id));
  m_quantities->setEnabled(m_quantities->count() > 0);
  m_quantities->setCurrentIndex(std::max(m_quantities->findData(kept), m_quantities->count() > 0 ? 0 : -1));
  showQuantity();
}

void RecordHistoryDialog::showQuantity() {
  const QuantityHistory* shown = quantity();
  m_csv->setEnabled(shown != nullptr);
  m_chart->setVisible(shown != nullptr);
  if (!shown) {
    m_says->setText(instrument() ? tr("These records state no constant with its uncertainty.") : QString());
    return;
  }
  m_chart->setHistory(shown->history, qText(quantityName(shown->id)), shown->unit);
  QStringList sentences;
  for (const std::string& sentence : historySentences(shown->history, shown->unit))
    sentences.append(visibleLine(sentence));
  m_says->setText(sentences.join(QStringLiteral("\n\n")));
}

std::vector<std::string> RecordHistoryDialog::remarks() const {
  std::vector<std::string> remarks = m_unusable;
  for (const auto& [copy, first] : m_histories.copies)
    remarks.push_back(tr("%1 holds the same record as %2: counted once.")
                          .arg(qText(m_records[copy].file), qText(m_records[first].file))
                          .toStdString());
  return remarks;
}

void RecordHistoryDialog::showRemarks() {
  QStringList lines;
  for (const std::string& remark : remarks()) lines.append(QStringLiteral("⚠ ") + visibleLine(remark));
  m_remarks->setText(lines.join(u'\n'));
  m_remarks->setVisible(!lines.isEmpty());
}

bool RecordHistoryDialog::exportJson() {
  return write(tr("Export history"), QStringLiteral("json"),
               historyJson(instrumentName(*instrument()), m_histories, remarks()));
}

bool RecordHistoryDialog::exportCsv() {
  return write(tr("Export history"), QStringLiteral("csv"), m_chart->numbers());
}

bool RecordHistoryDialog::write(const QString& title, const QString& suffix, const std::string& bytes) {
  const QDir folder = m_paths.isEmpty() ? QDir::home() : QFileInfo(m_paths.first()).absoluteDir();
  const QString name = QStringLiteral("record-history.") + suffix;
  return writeWhereAsked(m_dialogs, title, folder.filePath(name), suffix, bytes, m_paths).has_value();
}

}  // namespace alidade::ui
