#include "ui/self_test/installation_dialog.h"

#include <QDir>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPrinter>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <optional>

#include "core/base/failure.h"
#include "core/self_test/self_test_words.h"
#include "ui/dialogs/dialogs.h"
#include "ui/panels/parts/dialog_parts.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

InstallationDialog::InstallationDialog(Dialogs& dialogs, QWidget* parent)
    : QDialog(parent),
      m_dialogs(dialogs),
      m_work([this](const Background<SelfTest>::Shared& test) { take(*test); }),
      m_verdict(wrappedLabel()),
      m_lines(new QTreeWidget) {
  setWindowTitle(tr("Check of This Installation"));
  m_lines->setColumnCount(5);
  m_lines->setHeaderLabels({tr("Line"), tr("Expected"), tr("Found"), tr("Deviation"), tr("At most")});
  m_lines->setAccessibleName(tr("Lines of the check"));
  m_lines->setUniformRowHeights(true);
  m_lines->setAlternatingRowColors(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_verdict);
  layout->addWidget(m_lines, 1);
  layout->addWidget(createButtons());
  resize(960, 600);
  check();
}

QWidget* InstallationDialog::createButtons() {
  auto* row = new ButtonRow;
  m_save = row->add(tr("Save as &PDF…"), "save installation check");
  m_print = row->add(tr("P&rint…"), "print installation check");
  m_again = row->add(tr("Check &Again"), "check installation again");
  row->addRoom();
  auto* close = row->add(tr("Close"), "close");
  connect(m_save, &QPushButton::clicked, this, &InstallationDialog::savePdf);
  connect(m_print, &QPushButton::clicked, this, &InstallationDialog::print);
  connect(m_again, &QPushButton::clicked, this, &InstallationDialog::check);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  return row;
}

void InstallationDialog::check() {
  if (m_work.isAtWork()) return;
  m_verdict->setText(tr("Checking…"));
  for (QPushButton* button : {m_save, m_print, m_again}) button->setEnabled(false);
  m_work.start([](const std::stop_token&) { return runSelfTest(installedShare()); },
               [](const std::string& failure) {
                 return SelfTest{.checks = {brokenCheck(CheckGroup::Fits, "self-test", failure)},
                                 .environment = coreEnvironment()};
               });
}

void InstallationDialog::take(SelfTest ofCore) {
  m_check = std::make_shared<const InstallationCheck>(checkInstallation(std::move(ofCore)));
  m_verdict->setText(qText(verdictSentence(m_check->test)));
  colorVerdict();
  m_lines->clear();
  for (const CheckSection& section : sectionsOf(m_check->test)) {
    auto* group = new QTreeWidgetItem({qText(titleOf(section.group))});
    m_lines->addTopLevelItem(group);
    group->setFirstColumnSpanned(true);
    bool hasFailed = false;
    for (const auto& [check, reason] : section.lines) {
      auto* line = new QTreeWidgetItem(
          group, {QStringLiteral("%1: %2").arg(visibleLine(check->name), qText(outcomeText(check->outcome))),
                  visibleLine(check->expected), visibleLine(check->found), qText(shareText(check->deviation)),
                  qText(shareText(check->tolerance))});
      for (int column = 0; column < m_lines->columnCount(); ++column)
        line->setToolTip(column, tipText(qText(section.reasons[reason])));
      if (check->outcome != SelfCheck::Outcome::Failed) continue;
      hasFailed = true;
      line->setForeground(0, stateColor(palette(), State::Bad));
    }
    group->setExpanded(hasFailed || m_lines->topLevelItemCount() == 1);
  }
  for (int column = 0; column < m_lines->columnCount(); ++column) m_lines->resizeColumnToContents(column);
  for (QPushButton* button : {m_save, m_print, m_again}) button->setEnabled(true);
  emit checked();
}

QString InstallationDialog::verdict() const {
  return m_verdict->text();
}

void InstallationDialog::colorVerdict() {
  if (!m_check) return;
  QPalette colored = palette();
  colored.setColor(QPalette::WindowText,
                   stateColor(palette(), m_check->test.hasPassed() ? State::Good : State::Bad));
  m_verdict->setPalette(colored);
}

void InstallationDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colorVerdict();
}

bool InstallationDialog::savePdf() {
  if (!m_check) return false;
  const QString title = tr("Save check of this installation");
  const QString path = m_dialogs.askExportPath(
      title,
      QDir::home().filePath(
          QStringLiteral("alidade-self-test-%1.pdf").arg(m_check->at.date().toString(Qt::ISODate))),
      QStringLiteral("pdf"));
  if (path.isEmpty()) return false;
  std::optional<Result<QString>> written;
  const auto failure =
      failureOf([&] { written = writeInstallationCheck(*m_check, path, m_dialogs.readFiles()); });
  if (!failure && *written) return true;
  m_dialogs.showProblem(title, visibleLine(failure ? *failure : written->problem().text()));
  return false;
}

bool InstallationDialog::print() {
  if (!m_check) return false;
  QPrinter printer(QPrinter::HighResolution);
  const ReportPaper paper;
  printer.setDocName(windowTitle());
  printer.setPageLayout(paper.layout());
  if (!m_dialogs.askPrinter(printer, tr("Print check of this installation"))) return false;
  printer.setFullPage(true);  // a newly chosen printer may have margins of its own
  if (paintInstallationCheck(printer, *m_check, paper)) return true;
  m_dialogs.showProblem(windowTitle(),
                        tr("Alidade cannot print on “%1”: choose another printer, or save a PDF.")
                            .arg(visibleLine(printer.printerName())));
  return false;
}

}  // namespace alidade::ui
