#include "tests/ui/monkey/monkey.h"

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QTest>
#include <algorithm>

#include "core/session/session_file.h"
#include "tests/ui/monkey/monkey_dialogs.h"
#include "ui/main_window.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/result/result_panel.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/text/session_difference.h"

namespace alidade::ui {

namespace {

constexpr int longestLog = 400;
constexpr int patience = 120000;  // ms, for the slowest job under sanitizers

QString warning;  // the first one since the last check

void keepWarning(QtMsgType type, const QMessageLogContext&, const QString& text) {
  const bool isOfOffscreen = text.startsWith(QStringLiteral("This plugin does not support "));
  const bool isOfHands = text == QStringLiteral("Keyboard event not accepted by receiving widget") ||
                         text == QStringLiteral("Mouse event occurs outside target window");
  if (type == QtDebugMsg || type == QtInfoMsg || isOfOffscreen || isOfHands || !warning.isEmpty()) return;
  warning = text;
}

/// Copies the samples into the folder, since the monkey saves over them.
void copySamples(const QDir& folder) {
  const QDir samples(QStringLiteral(ALIDADE_SAMPLES_DIR));
  for (const QString& name : samples.entryList({QStringLiteral("*.alidade")}))
    QFile::copy(samples.filePath(name), folder.filePath(name));
}

QString difference(const Session& one, const Session& other) {
  QStringList lines;
  for (const EntryDifference& entry : differenceOf(one, other).entries)
    lines.append(QStringLiteral("%1: “%2”, “%3”").arg(entry.where, entry.mine, entry.theirs));
  return lines.join(u'\n');
}

/// The texts of a result panel, except the hint on the gap.
QStringList saidBy(const ResultPanel& panel) {
  QStringList texts;
  for (const QLabel* label : panel.findChildren<QLabel*>())
    if (label->isVisibleTo(&panel) && label->objectName() != QStringLiteral("gap hint"))
      texts.append(label->text());
  return texts;
}

/// Unfolds in `panel` what is unfolded in `other`: details, comparison.
void foldAs(const ResultPanel& other, ResultPanel& panel) {
  const auto buttons = panel.findChildren<QAbstractButton*>();
  const auto others = other.findChildren<QAbstractButton*>();
  for (qsizetype i = 0; i < std::min(buttons.size(), others.size()); ++i)
    buttons[i]->setChecked(others[i]->isChecked());
}

}  // namespace

Monkey::Monkey(unsigned seed, Report report)
    : m_chance(seed),
      m_report(std::move(report)),
      m_housekeeper(seed),
      m_hands(m_chance, QDir(m_folder.path()), [this](const QString& deed) { say(deed); }) {
  warning.clear();
  QApplication::setQuitOnLastWindowClosed(false);
  qInstallMessageHandler(keepWarning);
  copySamples(QDir(m_folder.path()));
  openWindow();
}

Monkey::~Monkey() {
  m_window.reset();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  qInstallMessageHandler(nullptr);
  QApplication::setQuitOnLastWindowClosed(true);
}

/// Opens a window with a sample or an empty session. Destroys the previous one while its jobs are running.
void Monkey::openWindow() {
  auto dialogs = std::make_unique<MonkeyDialogs>(m_chance, QDir(m_folder.path()));
  const QString path = m_chance.oneIn(4) ? QString() : dialogs->present(QStringLiteral("*.alidade"));
  say(QStringLiteral("a window with %1").arg(path.isEmpty() ? QStringLiteral("nothing") : path));
  m_window.reset();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  m_window = std::make_unique<MainWindow>(std::move(dialogs));
  SessionDocument& document = m_window->document();
  m_first = sessionText();
  m_gap.reset();
  QObject::connect(&document, &SessionDocument::identityChanged, m_window.get(), [this, &document] {
    if (document.undoStack().count() == 0) m_first = sessionText();
  });
  QObject::connect(&m_window->job(), &FitJob::evaluated, m_window.get(),
                   [this](const SharedEvaluation& evaluation) { m_evaluation = evaluation; });
  const auto keep = [this](const SharedGap& gap) { m_gap = gap; };
  QObject::connect(&m_window->jobs(), &SessionJobs::gapChanged, m_window.get(), keep);
  QObject::connect(&m_window->gapJob(), &GapJob::completed, m_window.get(), keep);
  QObject::connect(&m_window->jobs(), &SessionJobs::gapCleared, m_window.get(), [this] { m_gap.reset(); });
  m_window->show();
  QApplication::setActiveWindow(m_window.get());
  if (!path.isEmpty()) m_window->files().open(path);
  m_hands.take(m_window.get());
}

std::string Monkey::sessionText() const {
  if (!m_window) return {};
  Session session = m_window->document().session();
  session.journal.clear();  // an undo across a save enters the journal
  return writeSession(session);
}

void Monkey::say(const QString& deed) {
  const QString line = QStringLiteral("%1  %2").arg(m_events).arg(deed);
  m_log.append(line);
  if (m_log.size() > longestLog) m_log.removeFirst();
  if (m_report) m_report(line);
}

void Monkey::complain(const QString& what) {
  if (m_complaint.isEmpty()) m_complaint = what;
}

void Monkey::play(int events) {
  for (int end = m_events + events; m_events < end && m_complaint.isEmpty(); ++m_events) {
    if (!m_window->isVisible() || m_chance.oneIn(400)) openWindow();
    m_hands.doAnything();
    if (m_chance.oneIn(3)) QCoreApplication::processEvents(QEventLoop::AllEvents, m_chance.below(10));
    if (!warning.isEmpty()) complain(QStringLiteral("Qt warns: ") + std::exchange(warning, {}));
    if (m_chance.oneIn(100)) look();
  }
  if (m_complaint.isEmpty()) look();
}

/// Waits until nothing is open and every job is done.
bool Monkey::rest() {
  const bool withGap = m_chance.oneIn(4);
  QElapsedTimer clock;
  clock.start();
  const auto isBusy = [&] {
    return Housekeeper::isBusy() || !m_window->job().isIdle() || (withGap && !m_window->gapJob().isIdle());
  };
  for (int quiet = 0; quiet < 3; quiet = isBusy() ? 0 : quiet + 1) {  // posted events may start new work
    if (clock.elapsed() > patience) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
  }
  return true;
}

void Monkey::look() {
  say(QStringLiteral("look"));
  m_window->commitPending();
  if (!rest()) return complain(QStringLiteral("the jobs do not end"));
  lookAtFile();
  lookAtTables();
  lookAtResult();
  lookAtGap();
  lookAtUndo();
}

void Monkey::lookAtFile() {
  const std::string text = sessionText();
  const Result<Session> back = readSession(text);
  if (!back)
    complain(QStringLiteral("what is written is no session: ") +
             QString::fromStdString(back.problem().text()));
  else if (writeSession(*back) != text)
    complain(QStringLiteral("what is written is read as another session"));
}

void Monkey::lookAtTables() {
  const auto* tabs = m_window->findChild<PositionTabs*>();
  const auto& positions = m_window->document().session().positions;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const ReadingsTable* table = tabs->table(i);
    const auto rows = static_cast<int>(positions[i].readings.size());
    if (!table || table->model()->rowCount() != rows + 1)
      return complain(QStringLiteral("position %1 has another number of rows in its table").arg(i));
    for (int row = 0; row < rows; ++row) {
      const QModelIndex cell = table->model()->index(row, static_cast<int>(ReadingColumn::Vertical));
      const std::string& typed = positions[i].readings[static_cast<std::size_t>(row)].vertical;
      if (cell.data(Qt::EditRole).toString().toStdString() != typed)
        return complain(QStringLiteral("position %1, row %2 is not as it was typed").arg(i).arg(row));
    }
  }
  if (tabs->table(positions.size())) complain(QStringLiteral("there are more tables than positions"));
}

/// Compares the panel with one that has seen only this session.
void Monkey::lookAtResult() {
  const Session& session = m_window->document().session();
  if (!m_evaluation) return complain(QStringLiteral("no fit is shown"));
  if (m_evaluation->session != session)
    return complain(QStringLiteral("the fit shown is of another session:\n") +
                    difference(m_evaluation->session, session));
  m_window->pageTabs().first()->setCurrentIndex(0);
  ResultPanel alone;
  const Evaluation evaluation = evaluateFit(session);
  alone.setEvaluation(evaluation);
  if (m_window->gapJob().isIdle() && m_gap && m_gap->evaluation->session == session) {
    alone.setHeadline(headlineOf(*m_gap));
  } else {
    alone.setHeadline(headlineOf(evaluation));
  }
  const auto* shown = m_window->findChild<ResultPanel*>();
  foldAs(*shown, alone);
  if (saidBy(alone) != saidBy(*shown))
    complain(QStringLiteral("the result is said to be\n%1\nbut is\n%2")
                 .arg(saidBy(*shown).join(u'|'), saidBy(alone).join(u'|')));
}

void Monkey::lookAtGap() {
  if (!m_window->gapJob().isIdle() || !m_gap) return;
  if (m_gap->evaluation->session != m_window->document().session())
    complain(QStringLiteral("the diagnosis shown is of another session"));
}

void Monkey::lookAtUndo() {
  QUndoStack& stack = m_window->document().undoStack();
  const std::string present = sessionText();
  const int index = stack.index();
  stack.setIndex(0);
  if (sessionText() != m_first) complain(QStringLiteral("undo does not lead back to the first state"));
  stack.setIndex(stack.count());
  stack.setIndex(index);
  if (sessionText() != present) complain(QStringLiteral("redo does not lead to the present state"));
}

}  // namespace alidade::ui
