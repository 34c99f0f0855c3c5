// How long from a committed cell edit to the repainted charts: undo step, fit in the background, new figures,
// paint. Prints the median and the worst of 200 edits. Offscreen unless QT_QPA_PLATFORM says otherwise.

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <vector>

#include "ui/charts/arc_chart.h"
#include "ui/charts/residual_chart.h"
#include "ui/commands/edit_readings.h"
#include "ui/main_window.h"
#include "ui/settings/theme.h"

namespace {

using namespace alidade;
using namespace alidade::ui;

/// Counts the paint events of a widget and what it contains.
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

/// Milliseconds from the edit until the fit was shown and both charts have painted it.
double editOnce(MainWindow& window, PaintCounter& arcs, PaintCounter& residuals, int edit) {
  bool shown = false;
  const auto watch = QObject::connect(&window.job(), &FitJob::evaluated, &window, [&] {
    shown = true;
    arcs.paints = residuals.paints = 0;
  });
  const auto rows = window.document().session().positions.front().readings.size();
  QElapsedTimer clock;
  clock.start();
  ReadingsEditor(window.document(), 0)
      .setCell({static_cast<std::size_t>(edit) % rows, ReadingColumn::Vertical},
               "85 " + std::to_string(10 + edit % 40) + " 00");
  while (!shown || arcs.paints == 0 || residuals.paints == 0) {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  const double milliseconds = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
  QObject::disconnect(watch);
  return milliseconds;
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  setUpApplication(application);
  QTemporaryDir settings;  // the user's are neither read nor written
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  MainWindow window;
  window.show();
  const QString path =
      application.arguments().value(1, QStringLiteral(ALIDADE_SAMPLES_DIR "/paper-table-1.alidade"));
  if (!window.files().open(path)) return 2;
  while (!window.job().isIdle()) QApplication::processEvents();
  QApplication::processEvents();

  PaintCounter arcs(window.findChild<ArcChart*>());
  PaintCounter residuals(window.findChild<ResidualChart*>());
  std::size_t readings = 0;
  for (const Position& position : window.document().session().positions) readings += position.readings.size();
  std::vector<double> times;
  for (int edit = 0; edit < 200; ++edit) times.push_back(editOnce(window, arcs, residuals, edit));
  std::sort(times.begin(), times.end());
  std::printf("committed edit to repainted charts, %zu points: median %.2f ms, worst %.2f ms of %zu edits\n",
              readings, times[times.size() / 2], times.back(), times.size());
}
