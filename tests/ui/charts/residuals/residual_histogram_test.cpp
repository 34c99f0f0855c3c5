#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QSettings>
#include <QtCharts/QChart>
#include <QtCharts/QLineSeries>
#include <cmath>
#include <numeric>

#include "core/exchange/csv_table.h"
#include "tests/ui/support.h"
#include "ui/charts/residuals/residual_plot.h"

namespace alidade::ui {
namespace {

using Over = ResidualChoice::Over;

void prepare(ResidualPlot& plot, const Evaluation& evaluation, const ResidualChoice& choice) {
  plot.setStyle(printStyle(QStringLiteral("DejaVu Sans")));
  plot.setEvaluation(evaluation);
  plot.setChoice(choice);
  plot.arrange({700, 400});
}

QString legendText(const ResidualPlot& plot) {
  QStringList texts;
  for (const LegendEntry& entry : plot.legend().entries()) texts.append(entry.text);
  return texts.join(u'\n');
}

struct Class {
  double lower, upper, count, expected;
};

std::vector<Class> classesOf(const ResidualPlot& plot) {
  const std::string csv = plot.csv();
  CsvTable table(csv);
  table.next();
  std::vector<Class> classes;
  while (const auto row = table.next()) {
    const auto number = [&](std::size_t column) { return std::stod(row->cells[column].text); };
    classes.push_back({number(0), number(1), number(2), number(3)});
  }
  return classes;
}

double residualOf(const ResidualPlot& plot, const Mark& mark) {
  const DrawnResidual& residual = plot.picture().residuals[mark.index];
  return plot.choice().isStandardised ? residual.standardised : residual.arcsec;
}

TEST(ResidualHistogram, CountsEveryResidualInItsClass) {
  for (const bool isStandardised : {false, true}) {
    ResidualPlot plot;
    prepare(plot, evaluate(paperSession()), {.over = Over::Count, .isStandardised = isStandardised});
    const std::vector<Class> classes = classesOf(plot);
    double all = 0, expected = 0;
    for (const Class& one : classes) {
      all += one.count;
      expected += one.expected;
      const auto inside = std::ranges::count_if(plot.markers().marks(), [&](const Mark& mark) {
        return residualOf(plot, mark) >= one.lower && residualOf(plot, mark) < one.upper;
      });
      EXPECT_EQ(inside, one.count) << one.lower;
      // The marks of a class are in its bar, one above the other.
      double sum = 0;
      for (const Mark& mark : plot.markers().marks())
        if (mark.at.x() > one.lower && mark.at.x() < one.upper) sum += mark.at.y();
      EXPECT_DOUBLE_EQ(sum, one.count * one.count / 2);
    }
    EXPECT_EQ(all, 68);
    EXPECT_EQ(plot.markers().marks().size(), 68u);
    EXPECT_NEAR(expected, 68, 0.2) << "the classes reach beyond 3 σ";
    EXPECT_TRUE(legendText(plot).contains(isStandardised ? QStringLiteral("expected if normal, σ = 1")
                                                         : QStringLiteral("expected for the stated σ = 2″")))
        << legendText(plot).toStdString();
    EXPECT_TRUE(plot.describe(plot.markers().marks()[0]).contains(QStringLiteral("class from")));
    for (const Mark& mark : plot.markers().marks())
      EXPECT_TRUE(plot.plotArea().contains(plot.markers().scenePosition(mark)));
  }
}

TEST(ResidualHistogram, ExpectsEachCircleByItsOwnSigma) {
  Session session = paperSession();
  session.instrument.sigmaVerticalArcsec = "5";
  ResidualPlot plot;
  prepare(plot, evaluate(session), {.over = Over::Count});
  const auto below = [](double z) { return std::erfc(-z / std::sqrt(2)) / 2; };
  for (const Class& one : classesOf(plot)) {
    double expected = 0;
    for (const double sigma : {2.0, 5.0})
      expected += 34 * (below(one.upper / sigma) - below(one.lower / sigma));
    EXPECT_NEAR(one.expected, expected, 1e-9);
  }
  EXPECT_TRUE(legendText(plot).contains(QStringLiteral("vertical 5″, horizontal 2″")))
      << legendText(plot).toStdString();
}

TEST(ResidualHistogram, ARangeSetByHandLeavesOutWhatIsBeyondAndSaysHowMuch) {
  const Evaluation evaluation = evaluate(paperSession());
  ResidualPlot plot;
  prepare(plot, evaluation, {});
  const auto beyond = std::ranges::count_if(plot.markers().marks(),
                                            [](const Mark& mark) { return std::abs(mark.at.y()) > 10; });
  ASSERT_GT(beyond, 0);
  for (const Over over : {Over::Slider, Over::Order, Over::Count}) {
    ResidualChoice choice{.over = over};
    choice.setReach(10);
    plot.setChoice(choice);
    EXPECT_EQ(plot.markers().marks().size(), 68u - static_cast<std::size_t>(beyond));
    EXPECT_TRUE(legendText(plot).contains(QStringLiteral("not drawn: %1 beyond ±10″").arg(beyond)))
        << legendText(plot).toStdString();
    const QRectF shown = plot.sceneFromAxes().inverted().mapRect(plot.plotArea());
    EXPECT_NEAR(over == Over::Count ? shown.right() : shown.bottom(), 10, 1e-9);
    EXPECT_NEAR(over == Over::Count ? shown.left() : shown.top(), -10, 1e-9);
    if (over == Over::Count) continue;
    const std::string csv = plot.csv();
    EXPECT_EQ(std::ranges::count(csv, '\n'), 69) << "the table has every residual";
  }
}

TEST(ResidualHistogram, CountsInWholeNumbers) {
  ResidualPlot plot;
  prepare(plot, evaluate(paperSession()), {.over = Over::Count});
  for (const int height : {130, 400, 1080}) {
    plot.arrange(QSize(500, height));
    for (QGraphicsItem* item : plot.scene()->items())
      if (const auto* chart = dynamic_cast<QChart*>(item))
        for (QAbstractAxis* axis : chart->axes(Qt::Vertical)) {
          const double step = qobject_cast<QValueAxis*>(axis)->tickInterval();
          EXPECT_NEAR(step, std::round(step), 1e-9);
        }
  }
}

}  // namespace
}  // namespace alidade::ui
