#include "ui/series/record_history_dialog.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
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
#include "ui/panels/parts/statement_view.h"
#include "ui/series/history_chart.h"
#include "ui/series/history_choices.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

RecordHistoryDialog::RecordHistoryDialog(Dialogs& dialogs, QWidget* parent)
    : QDialog(parent),
      m_dialogs(dialogs),
      m_table(new StatementTable(recordTable({}, {}))),
      m_choices(new HistoryChoices(
          {.owner = tr("Instrument"),
           .ownerLabel = tr("&Instrument"),
           .baseline = tr("Records in the baseline"),
           .all = tr("all records"),
           .tip = tr("The first records define centre line and limits for the later ones")})),
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
  column->addWidget(m_choices);
  column->addWidget(below, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(split(Qt::Vertical, "record history", {m_table, lower}, {160, 400}), 1);
  layout->addWidget(m_remarks);
  layout->addWidget(createButtons());
  resize(980, 640);
  connect(m_choices, &HistoryChoices::ownerChosen, this, &RecordHistoryDialog::showInstrument);
  connect(m_choices, &HistoryChoices::quantityChosen, this, &RecordHistoryDialog::showQuantity);
  connect(m_choices, &HistoryChoices::baselineChosen, this, &RecordHistoryDialog::showInstruments);
  connect(&m_chart->files(), &ChartFiles::fileWanted, this,
          [this](const ChartFile& file) { write(tr("Save chart"), file.suffix, file.bytes.toStdString()); });
  showInstruments();
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
  m_choices->setMostInBaseline(most);
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
  const auto chosen = m_choices->owner();
  return chosen ? &m_histories.instruments[*chosen] : nullptr;
}

const QuantityHistory* RecordHistoryDialog::quantity() const {
  const InstrumentHistory* shown = instrument();
  const auto chosen = m_choices->quantity();
  return shown && chosen ? &shown->quantities[*chosen] : nullptr;
}

void RecordHistoryDialog::showInstruments() {
  QStringList names;
  for (InstrumentHistory& one : m_histories.instruments) {
    setBaseline(one, static_cast<std::size_t>(m_choices->baseline()));
    names.append(menuText(qText(instrumentName(one))));
  }
  m_choices->setOwners(names);
  m_json->setEnabled(!names.isEmpty());
  showInstrument();
}

void RecordHistoryDialog::showInstrument() {
  const InstrumentHistory* chosen = instrument();
  const InstrumentHistory shown = chosen ? *chosen : InstrumentHistory();
  showRemarks(shown);
  m_table->setStatement(recordTable(shown, localDay()));
  m_choices->setQuantities(shown.quantities);
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
  m_says->setText(paragraphs(historySentences(shown->history, shown->unit)));
}

std::vector<std::string> RecordHistoryDialog::remarks() const {
  std::vector<std::string> remarks = m_unusable;
  for (const auto& [copy, first] : m_histories.copies)
    remarks.push_back(tr("%1 holds the same record as %2: counted once.")
                          .arg(qText(m_records[copy].file), qText(m_records[first].file))
                          .toStdString());
  return remarks;
}

void RecordHistoryDialog::showRemarks(const InstrumentHistory& shown) {
  QStringList lines;
  for (const auto& sentences : {remarks(), shown.leftOut})
    for (const std::string& remark : sentences) lines.append(QStringLiteral("⚠ ") + visibleLine(remark));
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
  return writeToChosenPath(m_dialogs, title, folder.filePath(name), suffix, bytes, m_paths).has_value();
}

}  // namespace alidade::ui
