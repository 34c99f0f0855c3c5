#include "ui/instrument/instrument_dialog.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/base/clock.h"
#include "core/series/instrument_check/check_record.h"
#include "core/series/instrument_check/check_statement.h"
#include "core/series/instrument_check/instrument_json.h"
#include "core/wording/findings.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/written_file.h"
#include "ui/instrument/check_chart.h"
#include "ui/instrument/check_input.h"
#include "ui/instrument/check_report.h"
#include "ui/panels/gap/gap_headline.h"
#include "ui/panels/parts/dialog_parts.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/settings/theme.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

InstrumentDialog::InstrumentDialog(Dialogs& dialogs, QWidget* parent)
    : QDialog(parent), m_dialogs(dialogs), m_input(new CheckInput(dialogs)), m_problem(wrappedLabel()) {
  setWindowTitle(tr("Instrument Check"));
  auto* parts = new QSplitter(Qt::Vertical);
  parts->addWidget(m_input);
  parts->addWidget(createResult());
  parts->setStretchFactor(1, 1);
  parts->setChildrenCollapsible(false);
  parts->setSizes({150, 440});
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(parts, 1);
  layout->addWidget(createButtons());
  resize(1060, 640);
  connect(m_input, &CheckInput::changed, this, [this] { m_job.ask(m_input->question()); });
  connect(&m_job, &InstrumentJob::checked, this, &InstrumentDialog::take);
  take(std::make_shared<const CheckedInstrument>());
}

QWidget* InstrumentDialog::createResult() {
  m_verdict = new GapHeadline;
  m_table = new StatementTable(stationsTable({}));
  m_table->setAccessibleName(tr("Result by station"));
  m_table->setPlaceholder(tr("Open files, or type rounds in two faces to several targets."));
  m_said = wrappedLabel();
  m_said->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_said->setContentsMargins(2, 2, 6, 2);
  auto* says = new QScrollArea;
  says->setWidget(m_said);
  says->setWidgetResizable(true);
  says->setFrameShape(QFrame::NoFrame);
  says->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  says->setAccessibleName(tr("What the check says"));
  m_chart = new CheckChart;
  m_view = new QComboBox;
  m_view->addItem(tr("Values over the rounds"), static_cast<int>(CheckPlot::View::Course));
  m_view->addItem(tr("Residuals"), static_cast<int>(CheckPlot::View::Residuals));
  m_view->addItem(tr("Collimation over the distance"), static_cast<int>(CheckPlot::View::Distance));
  m_view->setAccessibleName(tr("What the chart shows"));
  connect(m_view, &QComboBox::currentIndexChanged, this,
          [this] { m_chart->setView(static_cast<CheckPlot::View>(m_view->currentData().toInt())); });
  auto* drawn = new QWidget;
  auto* column = new QVBoxLayout(drawn);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_view, 0, Qt::AlignLeft);
  column->addWidget(m_chart, 1);
  auto* below = new QSplitter;
  below->addWidget(says);
  below->addWidget(drawn);
  below->setChildrenCollapsible(false);
  below->setSizes({430, 530});
  auto* result = new QWidget;
  auto* layout = new QVBoxLayout(result);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_problem);
  layout->addWidget(m_verdict);
  layout->addWidget(m_table, 1);
  layout->addWidget(below, 3);
  return result;
}

QWidget* InstrumentDialog::createButtons() {
  auto* row = new ButtonRow;
  m_json = row->add(tr("Export &JSON…"), "export check json");
  m_csv = row->add(tr("Export &CSV…"), "export check csv");
  m_pdf = row->add(tr("&PDF…"), "export check pdf");
  m_pdf->setToolTip(tr("The check as a document"));
  m_record = row->add(tr("&Save as Instrument Record…"), "save check record");
  m_record->setToolTip(
      tr("Collimation, index, tilt, offset of the line of sight and σ of the circles, for use in sessions"));
  row->addRoom();
  auto* close = row->add(tr("Close"), "close");
  connect(m_json, &QPushButton::clicked, this, &InstrumentDialog::exportJson);
  connect(m_csv, &QPushButton::clicked, this, &InstrumentDialog::exportCsv);
  connect(m_pdf, &QPushButton::clicked, this, &InstrumentDialog::exportPdf);
  connect(m_record, &QPushButton::clicked, this, &InstrumentDialog::saveRecord);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  return row;
}

void InstrumentDialog::take(const SharedInstrument& answer) {
  m_answer = answer;
  m_problem->setText(visibleLine(answer->problem));
  m_problem->setVisible(!answer->problem.empty());
  colorProblem();
  QStringList sentences;
  for (const Finding& finding : answer->findings)
    sentences.append((finding.severity == Severity::Note ? QString() : QStringLiteral("⚠ ")) +
                     visibleLine(sentencesOf(finding)));
  for (const std::string& remark : answer->remarks) sentences.append(capitalised(visibleLine(remark)) + u'.');
  const bool isEmpty = !answer->check && answer->problem.empty();
  m_said->setText(
      isEmpty ? tr("Rounds to several targets in both faces show the scatter of a direction and of a zenith "
                   "angle, and collimation, index and tilt of the trunnion axis. Allow half an hour, before "
                   "a series and after a transport. Observe three rounds to four targets around the horizon, "
                   "one of them steep, at distances like those of the work.")
              : sentences.join(QStringLiteral("\n\n")));
  m_verdict->setVisible(answer->check.has_value());
  if (answer->check) showVerdict();
  m_input->suggest(answer->identity);
  m_table->setStatement(stationsTable(answer->check.value_or(InstrumentCheck())));
  m_chart->setCheck(answer);
  m_json->setEnabled(answer->check.has_value());
  m_csv->setEnabled(answer->check.has_value());
  m_pdf->setEnabled(answer->check.has_value());
  m_record->setEnabled(answer->check && (answer->check->index.u > 0 || answer->check->collimation.u > 0));
}

void InstrumentDialog::showVerdict() {
  const Statement verdict = checkVerdict(*m_answer->check, m_answer->findings);
  QStringList sentences;
  for (const std::string& sentence : verdict.sentences) sentences.append(visibleLine(sentence));
  const std::optional<bool> passed = hasPassed(*m_answer->check);
  m_verdict->setText(visibleLine(verdict.title), sentences.join(u' '),
                     !passed   ? State::Quiet
                     : *passed ? State::Good
                               : State::Bad);
}

QString InstrumentDialog::said() const {
  return m_problem->isHidden() ? m_said->text() : m_problem->text();
}

void InstrumentDialog::colorProblem() {
  QPalette colored = palette();
  colored.setColor(QPalette::WindowText, stateColor(palette(), State::Bad));
  m_problem->setPalette(colored);
}

void InstrumentDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colorProblem();
}

bool InstrumentDialog::exportJson() {
  return write(tr("Export instrument check"), checkName(), QStringLiteral("json"),
               instrumentJson(m_answer->identity, *m_answer->check, m_answer->findings, m_answer->remarks));
}

bool InstrumentDialog::exportCsv() {
  return write(tr("Export residuals of the check"), checkName(), QStringLiteral("csv"),
               instrumentCsv(m_answer->identity, *m_answer->check));
}

bool InstrumentDialog::exportPdf() {
  const std::optional<std::string> pdf = checkPdf(*m_answer);
  if (pdf) return write(tr("Export instrument check"), checkName(), QStringLiteral("pdf"), *pdf);
  m_dialogs.showProblem(tr("Export instrument check"), tr("The pages could not be painted."));
  return false;
}

/// Saves the record with the date of the readings, or with today's date if no file states one.
bool InstrumentDialog::saveRecord() {
  CheckIdentity identity = m_answer->identity;
  if (identity.measuredOn.empty()) identity.measuredOn = localDay();
  if (const auto dated = identityOf(identity, {}); !dated) {
    m_dialogs.showProblem(tr("Save instrument record"), visibleLine(dated.problem().text()));
    return false;
  }
  const QString name = identity.serial.empty() ? checkName() : qText(identity.serial);
  return write(tr("Save instrument record"), name + u'-' + qText(identity.measuredOn),
               QStringLiteral("alidade-instrument"),
               writeInstrumentRecord(checkedRecord(*m_answer->check, identity)));
}

QString InstrumentDialog::checkName() const {
  const QStringList paths = m_input->paths();
  const QString name =
      paths.isEmpty() ? QStringLiteral("instrument") : QFileInfo(paths.first()).completeBaseName();
  return name + QStringLiteral("-check");
}

bool InstrumentDialog::write(const QString& title, const QString& name, const QString& suffix,
                             const std::string& bytes) {
  const QStringList paths = m_input->paths();
  const QDir folder = paths.isEmpty() ? QDir::home() : QFileInfo(paths.first()).absoluteDir();
  return writeToChosenPath(m_dialogs, title, folder.filePath(name + u'.' + suffix), suffix, bytes, paths)
      .has_value();
}

}  // namespace alidade::ui
