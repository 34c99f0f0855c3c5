// Measures the window with many rows: for each number of rows given (34, 10 000 and 100 000) it is opened,
// typed in, pasted into, undone, scrolled and paged through. For each step it prints the time until the fit
// is shown and painted, and the time this thread has worked on it. It also prints the longest time without
// handling input, with its cause. Work is processor time, which other programs affect less.

#include <malloc.h>

#include <QApplication>
#include <QClipboard>
#include <QElapsedTimer>
#include <QScrollBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>
#include <string>

#include "core/session/session_file.h"
#include "tests/support/large_session.h"
#include "ui/charts/arc/arc_chart.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/main_window.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/settings/theme.h"

namespace {

using namespace alidade;
using namespace alidade::ui;

double threadMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// Resident memory, MiB.
double residentMiB() {
  std::ifstream statm("/proc/self/statm");
  long pages = 0, resident = 0;
  statm >> pages >> resident;
  return static_cast<double>(resident) * 4096 / (1 << 20);
}

/// Records the single event that took this thread the longest time.
class WatchedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  void restart() { m_longest = 0; }
  double longest() const { return m_longest; }
  const std::string& longestOn() const { return m_on; }

  bool notify(QObject* receiver, QEvent* event) override {
    if (m_depth > 0) return QApplication::notify(receiver, event);
    const std::string on = std::string(receiver->metaObject()->className()) + " event " +
                           std::to_string(static_cast<int>(event->type()));
    const double before = threadMilliseconds();
    ++m_depth;
    const bool taken = QApplication::notify(receiver, event);
    --m_depth;
    note(threadMilliseconds() - before, on);
    return taken;
  }
  void note(double work, const std::string& on) {
    if (work <= m_longest) return;
    m_longest = work;
    m_on = on;
  }

 private:
  int m_depth = 0;
  double m_longest = 0;
  std::string m_on;
};

/// Counts the paint events of a widget and its children.
class PaintCounter : public QObject {
 public:
  explicit PaintCounter(QWidget* widget) : m_widget(widget) {
    for (QWidget* child : widget->findChildren<QWidget*>()) child->installEventFilter(this);
  }

  void restart() { m_paints = 0; }
  /// True if the widget was painted since `restart`, or is not visible.
  bool isPainted() const { return m_paints > 0 || !m_widget->isVisible(); }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++m_paints;
    return false;
  }

 private:
  QWidget* m_widget;
  int m_paints = 0;
};

class Load {
 public:
  Load(WatchedApplication& application, MainWindow& window)
      : m_application(application),
        m_window(window),
        m_arcs(window.findChild<ArcChart*>()),
        m_residuals(window.findChild<ResidualChart*>()) {
    QObject::connect(&window.job(), &FitJob::evaluated, &window, [this] {
      m_isShown = true;
      m_arcs.restart();
      m_residuals.restart();
    });
  }

  /// Measures the time until the fit caused by `act` is shown and painted.
  void edit(const char* what, const std::function<void()>& act) {
    m_isShown = false;
    measure(what, act, [this] { return isPainted() && m_window.job().isIdle(); });
  }
  /// Measures the time until only background work remains.
  void look(const char* what, const std::function<void()>& act) {
    measure(what, act, [] { return true; });
  }
  /// Waits for all background work.
  void rest(const char* what) {
    measure(
        what, [] {}, [this] { return m_window.job().isIdle() && !m_window.gapJob().isAtWork(); });
  }

 private:
  template <typename Done>
  void measure(const char* what, const std::function<void()>& act, Done done) {
    m_application.restart();
    QElapsedTimer clock;
    clock.start();
    const double before = threadMilliseconds();
    act();
    double longestTurn = threadMilliseconds() - before;
    m_application.note(longestTurn, "the action itself");
    double painted = 0;
    for (int turns = 0; turns < 3 || !done(); ++turns) {
      const double begin = threadMilliseconds();
      QApplication::processEvents(done() ? QEventLoop::AllEvents : QEventLoop::WaitForMoreEvents);
      longestTurn = std::max(longestTurn, threadMilliseconds() - begin);
      if (painted == 0 && isPainted()) painted = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
      if (clock.elapsed() > 120000) break;
    }
    std::printf(
        "  %-34s painted %8.1f ms, done %8.1f ms, work %7.1f ms, longest turn %7.1f ms, of it %7.1f in %s; "
        "%.0f MiB\n",
        what, painted, static_cast<double>(clock.nsecsElapsed()) * 1e-6, threadMilliseconds() - before,
        longestTurn, m_application.longest(), m_application.longestOn().c_str(), residentMiB());
    std::fflush(stdout);
  }

  WatchedApplication& m_application;
  MainWindow& m_window;
  PaintCounter m_arcs, m_residuals;
  bool m_isShown = false;

  bool isPainted() const { return m_isShown && m_arcs.isPainted() && m_residuals.isPainted(); }
};

QString blockOf(const Session& session, std::size_t rows) {
  QString text;
  const auto& readings = session.positions.front().readings;
  for (std::size_t i = 0; i < rows; ++i) {
    const Reading& reading = readings[i % readings.size()];
    text += QStringLiteral("%1\t%2\n")
                .arg(QString::fromStdString(reading.horizontal), QString::fromStdString(reading.vertical));
  }
  return text;
}

void run(WatchedApplication& application, std::size_t rows, const QString& folder) {
  Session session = test::largeSession(rows);
  const QString path = folder + QStringLiteral("/rows.alidade");
  std::ofstream(path.toStdString()) << writeSession(session);
  auto window = std::make_unique<MainWindow>();
  window->resize(1400, 900);
  window->show();
  while (!window->job().isIdle()) QApplication::processEvents();
  std::printf("%zu rows, %.0f MiB at first\n", rows, residentMiB());
  Load load(application, *window);
  load.edit("open", [&] { window->files().open(path); });
  const auto page = [&](std::size_t tabs, int index) {
    return [&window, tabs, index] { window->pageTabs()[static_cast<int>(tabs)]->setCurrentIndex(index); };
  };
  load.edit("type a cell", [&] {
    ReadingsEditor(window->document(), 0).setCell({3, ReadingColumn::Vertical}, "85 10 00");
  });
  load.look("save it", [&] { window->files().save(); });
  load.edit("undo it", [&] { window->undo(); });
  load.edit("type a cell that is no angle", [&] {
    ReadingsEditor(window->document(), 0).setCell({3, ReadingColumn::Vertical}, "85 99 00");
  });
  load.edit("undo it", [&] { window->undo(); });
  load.edit("change L", [&] {
    window->document().beginTogether({});
    window->document().endTogether();
    ReadingsEditor(window->document(), 0).setCell({4, ReadingColumn::Vertical}, "85 10 01");
  });
  load.edit("undo it", [&] { window->undo(); });
  ReadingsTable* table = window->currentTable();
  load.look("go to the last row",
            [&] { table->selectCell(static_cast<int>(rows / 2) - 1, ReadingColumn::Horizontal); });
  load.look("scroll to the middle",
            [&] { table->verticalScrollBar()->setValue(table->verticalScrollBar()->maximum() / 2); });
  load.look("next row", [&] { QTest::keyClick(table, Qt::Key_Down); });
  load.look("page of the reliability", page(1, 2));
  load.look("next row", [&] { QTest::keyClick(table, Qt::Key_Up); });
  load.edit("type a cell, reliability in front", [&] {
    ReadingsEditor(window->document(), 0).setCell({3, ReadingColumn::Vertical}, "85 10 00");
  });
  load.edit("undo it", [&] { window->undo(); });
  load.look("page of the budget", page(0, 1));
  load.look("page of the residuals", page(1, 0));
  load.look("other position", [&] { window->reveal({.position = 1, .reading = 0, .field = "vertical"}); });
  load.look("back", [&] { window->reveal({.position = 0, .reading = 0, .field = "horizontal"}); });
  load.look("resize", [&] { window->resize(1300, 850); });
  const std::size_t pasted = std::min<std::size_t>(rows / 2, 10000);
  QApplication::clipboard()->setText(blockOf(session, pasted));
  load.edit("paste over rows", [&] {
    table->selectCell(1, ReadingColumn::Horizontal);
    table->paste();
  });
  load.edit("undo it", [&] { window->undo(); });
  load.edit("paste below the last row", [&] {
    table->selectCell(static_cast<int>(rows), ReadingColumn::Horizontal);
    table->paste();
  });
  load.edit("undo it", [&] { window->undo(); });
  load.look("select all", [&] { table->selectAll(); });
  load.look("copy", [&] { table->copy(); });
  load.edit("exclude all", [&] { table->toggleExcluded(); });
  load.edit("undo it", [&] { window->undo(); });
  load.edit("clear all", [&] {
    table->selectAll();
    table->clearCells();
  });
  load.edit("undo it", [&] { window->undo(); });
  load.edit("delete all", [&] {
    table->selectAll();
    table->deleteSelected();
  });
  load.edit("undo it", [&] { window->undo(); });
  load.edit("one row excluded", [&] { ReadingsEditor(window->document(), 0).setExcluded({5}, true); });
  load.edit("undo it", [&] { window->undo(); });
  for (Position& position : session.positions)
    for (Reading& reading : position.readings) reading.vertical = "85 99 00";
  load.edit("all rows unusable", [&] { window->document().startWith(session); });
  load.edit("mend one of them", [&] {
    ReadingsEditor(window->document(), 0).setCell({3, ReadingColumn::Vertical}, "85 10 00");
  });
  load.edit("new", [&] { window->document().startNew(); });
  load.look("close", [&] { window.reset(); });
  malloc_trim(0);
  std::printf("  %.0f MiB after\n", residentMiB());
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  WatchedApplication application(argc, argv);
  setUpApplication(application);
  QTemporaryDir settings;  // the user's settings are neither read nor written
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  if (argc < 2)
    for (const std::size_t rows : {34, 10000, 100000}) run(application, rows, settings.path());
  for (int i = 1; i < argc; ++i)
    run(application, static_cast<std::size_t>(std::atoll(argv[i])), settings.path());
}
