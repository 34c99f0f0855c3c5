// Measures how long a chart takes on the window's thread to show another fit, to be zoomed and moved, and to
// draw something else, each until it is painted. Prints minimum, median and maximum of many runs, and how
// often a frame of 60 Hz was missed, at 34 rows and at 10 000, or at those given. Times are this thread's
// processor time, which other programs affect less.

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QSettings>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

#include "core/evaluation/evaluation.h"
#include "tests/support/large_session.h"
#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/residuals/residual_plot.h"
#include "ui/settings/theme.h"

namespace {

using namespace alidade;
using namespace alidade::ui;

constexpr int times = 40;
constexpr double frame = 1000.0 / 60;

double threadMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

void measure(const char* what, Plot& plot, const QSize& size, const std::function<void(int)>& act) {
  std::vector<double> took;
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  for (int i = 0; i < times; ++i) {
    const double before = threadMilliseconds();
    act(i);
    QPainter painter(&image);
    plot.paint(&painter);
    painter.end();
    took.push_back(threadMilliseconds() - before);
  }
  std::sort(took.begin(), took.end());
  const auto missed = took.end() - std::upper_bound(took.begin(), took.end(), frame);
  std::printf("  %-34s least %6.2f ms, median %6.2f ms, worst %6.2f ms, beyond a frame %2td of %d\n", what,
              took.front(), took[took.size() / 2], took.back(), missed, times);
}

void lookAround(Plot& plot, const QSize& size) {
  measure("zoom in and out", plot, size,
          [&](int i) { plot.zoom(i % 20 < 10 ? 1.25 : 0.8, plot.plotArea().center() + QPointF(20, 10)); });
  plot.zoom(4, plot.plotArea().center());
  measure("move", plot, size, [&](int i) { plot.move(QPointF(i % 2 ? 15 : -15, i % 4 < 2 ? 8 : -8)); });
  plot.showWhole();
  measure("step from point to point", plot, size, [&](int) { plot.step(Plot::Step::Right); });
}

void run(std::size_t rows) {
  const Evaluation one = evaluateFit(test::largeSession(rows));
  Session other = one.session;
  other.positions[0].readings[3].vertical = other.positions[0].readings[4].vertical;
  const Evaluation two = evaluateFit(other);
  const auto shown = [&](int i) -> const Evaluation& { return i % 2 ? one : two; };
  const QSize arcSize(620, 520), residualSize(900, 320);
  const PlotStyle style = screenStyle(QApplication::palette(), QApplication::font());
  std::printf("%zu rows, arcs\n", rows);
  ArcPlot arcs;
  arcs.setStyle(style);
  arcs.arrange(arcSize);
  measure("another fit", arcs, arcSize, [&](int i) { arcs.setEvaluation(shown(i)); });
  lookAround(arcs, arcSize);
  std::printf("%zu rows, residuals\n", rows);
  ResidualPlot residuals;
  residuals.setStyle(style);
  residuals.arrange(residualSize);
  using Over = ResidualChoice::Over;
  for (const auto& [name, over] :
       {std::pair("another fit, over s", Over::Slider), std::pair("another fit, in order", Over::Order),
        std::pair("another fit, normal quantiles", Over::Normal)}) {
    residuals.setChoice({.over = over});
    measure(name, residuals, residualSize, [&](int i) { residuals.setEvaluation(shown(i)); });
  }
  measure("another choice", residuals, residualSize,
          [&](int i) { residuals.setChoice({.over = i % 2 ? Over::Elevation : Over::Azimuth}); });
  lookAround(residuals, residualSize);
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  setUpApplication(application);
  QTemporaryDir settings;  // the user's settings are neither read nor written
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  const QStringList given = application.arguments().mid(1);
  for (const QString& rows :
       given.isEmpty() ? QStringList{QStringLiteral("34"), QStringLiteral("10000")} : given)
    run(rows.toULongLong());
}
