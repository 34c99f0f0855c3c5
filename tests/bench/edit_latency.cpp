// Measures the time from a committed cell edit to the repainted charts: undo step, fit in the background, new
// figures, paint. Prints minimum, median and maximum of 200 edits that correct a last digit, of 200 that err
// by degrees and of the 200 that correct these one by one. Also prints the processor time of the window's own
// thread, which other programs affect less. Offscreen unless QT_QPA_PLATFORM says otherwise.

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "ui/charts/arc/arc_chart.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/commands/edit_readings.h"
#include "ui/main_window.h"
#include "ui/settings/theme.h"

namespace {

using namespace alidade;
using namespace alidade::ui;

/// Counts the paint events of a widget and its children.
class PaintCounter : public QObject {
 public:
  explicit PaintCounter(QWidget* widget) {
    widget->installEventFilter(this);
    for (QWidget* child : widget->findChildren<QWidget*>()) child->installEventFilter(this);
  }

  int paints = 0;

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++paints;
    return false;
  }
};

/// Milliseconds from the edit.
struct Times {
  double figures;  ///< until every view has received fit and figures
  double picture;  ///< until both charts are painted
  double work;     ///< of that, processor time of this thread
};

double threadMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// Changes the last digit of the typed text.
std::string corrected(std::string text) {
  const auto last = text.find_last_of("0123456789");
  text[last] = text[last] == '9' ? '0' : static_cast<char>(text[last] + 1);
  return text;
}

std::string slipped(std::string text) {
  return text.front() == '7' ? "80 10 00" : "75 10 00";
}

Times editOnce(MainWindow& window, PaintCounter& arcs, PaintCounter& residuals, std::size_t row,
               const std::string& typed) {
  QElapsedTimer clock;
  const auto milliseconds = [&clock] { return static_cast<double>(clock.nsecsElapsed()) * 1e-6; };
  Times times{};
  const auto watch = QObject::connect(&window.job(), &FitJob::evaluated, &window, [&] {
    times.figures = milliseconds();
    arcs.paints = residuals.paints = 0;
  });
  const double before = threadMilliseconds();
  clock.start();
  ReadingsEditor(window.document(), 0).setCell({row, ReadingColumn::Vertical}, typed);
  while (times.figures == 0 || arcs.paints == 0 || residuals.paints == 0) {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  times.picture = milliseconds();
  times.work = threadMilliseconds() - before;
  QObject::disconnect(watch);
  return times;
}

constexpr std::size_t edits = 200;

void print(const char* what, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  std::printf("  %-28s least %6.2f ms, median %6.2f ms, worst %6.2f ms\n", what, times.front(),
              times[times.size() / 2], times.back());
}

void print(const char* what, std::size_t readings, const std::vector<Times>& all) {
  const auto each = [&all](double Times::*member) {
    std::vector<double> values;
    for (const Times& times : all) values.push_back(times.*member);
    return values;
  };
  std::printf("%zu edits that %s at %zu points, from the committed edit to\n", all.size(), what, readings);
  print("figures handed to the views", each(&Times::figures));
  print("repainted charts", each(&Times::picture));
  print("of that, this thread's work", each(&Times::work));
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  setUpApplication(application);
  QTemporaryDir settings;  // the user's settings are neither read nor written
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  const QString path =
      application.arguments().value(1, QStringLiteral(ALIDADE_SAMPLES_DIR "/paper-table-1.alidade"));
  if (const auto problem = SessionDocument().load(path)) {  // the window would ask a question that nobody
                                                            // answers
    std::fprintf(stderr, "%s: %s\n", qPrintable(path), problem->text().c_str());
    return 2;
  }
  MainWindow window;
  window.show();
  if (!window.files().open(path)) return 2;
  while (!window.job().isIdle()) QApplication::processEvents();
  QApplication::processEvents();

  PaintCounter arcs(window.findChild<ArcChart*>());
  PaintCounter residuals(window.findChild<ResidualChart*>());
  std::size_t readings = 0;
  for (const Position& position : window.document().session().positions) readings += position.readings.size();
  const std::vector<Reading>& rows = window.document().session().positions.front().readings;
  std::vector<Times> corrections, slips, repairs;
  for (std::size_t edit = 0; edit < edits; ++edit) {
    const std::size_t row = edit % rows.size();
    corrections.push_back(editOnce(window, arcs, residuals, row, corrected(rows[row].vertical)));
  }
  for (std::size_t edit = 0; edit < edits; ++edit) {
    const std::size_t row = edit % rows.size();
    const std::string intended = rows[row].vertical;
    slips.push_back(editOnce(window, arcs, residuals, row, slipped(intended)));
    repairs.push_back(editOnce(window, arcs, residuals, row, intended));
  }
  print("correct a last digit", readings, corrections);
  print("slip by degrees", readings, slips);
  print("mend the slip", readings, repairs);
}
