#include "ui/panels/gap/form_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QGraphicsScene>
#include <QLabel>
#include <QTest>
#include <QWheelEvent>
#include <map>

#include "core/session/session_file.h"
#include "tests/ui/language/speaking.h"
#include "tests/ui/support.h"
#include "ui/charts/gap/form_chart.h"
#include "ui/charts/gap/leftover_strips.h"
#include "ui/panels/gap/gap_panel.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The number of points on lines inside the plot area; all but six are on curves.
qsizetype linePoints(FormPlot& plot) {
  qsizetype count = 0;
  for (QGraphicsItem* item : plot.scene()->items())
    if (const auto* chart = dynamic_cast<QChart*>(item))
      for (const QAbstractSeries* series : chart->series())
        if (const auto* line = qobject_cast<const QLineSeries*>(series)) count += line->count();
  return count;
}

SharedGap gapOf(const char* sample) {
  static std::map<std::string, SharedGap> gaps;  // a diagnosis takes half a second
  SharedGap& gap = gaps[sample];
  if (!gap) {
    const QString path = samplePath(QStringLiteral("%1.alidade").arg(QString::fromLatin1(sample)));
    const auto evaluation = std::make_shared<const Evaluation>(evaluateFit(*loadSession(path.toStdString())));
    gap = std::make_shared<const Gap>(assessGap(evaluation));
  }
  return gap;
}

/// The page as it is shown.
struct Page {
  explicit Page(const char* sample) {
    panel.resize(900, 1600);
    panel.setGap(gapOf(sample));
    panel.show();
    QCoreApplication::processEvents();
  }
  FormChart* chart() {
    for (FormChart* chart : panel.findChildren<FormChart*>())
      if (chart->isVisibleTo(&panel)) return chart;
    return nullptr;
  }
  std::string shown() const {
    QString texts;
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->isVisibleTo(&panel)) texts += label->text() + QLatin1Char('\n');
    return texts.toStdString();
  }

  GapPanel panel;
};

TEST(FormList, TellsAndDrawsTheForm) {
  Page page("dented-guideway");
  EXPECT_THAT(page.shown(), HasSubstr("Form\nThe form: radius − 0.2"));
  EXPECT_THAT(page.shown(), HasSubstr("The model holds where s is within"));
  EXPECT_THAT(page.shown(), HasSubstr("On 272 readings held out of the fit, the form reduces the gap by"));
  FormChart* chart = page.chart();
  ASSERT_TRUE(chart);
  EXPECT_GT(linePoints(*chart->plot()), 100);
  EXPECT_EQ(chart->pointCount(), 2u * 136) << "every row before and after";
  EXPECT_THAT(chart->plot()->describe(chart->plot()->markers().marks().front()).toStdString(),
              HasSubstr("Axis at 0°, point 1, round 1, face 1\nbefore "));
  EXPECT_THAT(chart->numbers(), HasSubstr("\"Axis at 0°, point 1"));
}

TEST(FormList, IsHiddenWhereThereIsNone) {
  for (const char* sample : {"clean-session", "trunnion-tilt"}) {
    Page page(sample);
    EXPECT_THAT(page.shown(), Not(HasSubstr("The form:"))) << sample;
    EXPECT_FALSE(page.chart()) << sample;
  }
}

TEST(FormList, DrawsBothCirclesOfAnOrientation) {
  Page page("settling-tripod");
  ASSERT_TRUE(page.chart());
  const FormPlot& plot = *page.chart()->plot();
  std::size_t vertical = 0;
  for (const FormPoint& point : plot.form().trace.points) vertical += point.isVertical ? 1 : 0;
  EXPECT_GT(vertical, 20u);
  EXPECT_GT(plot.form().trace.points.size() - vertical, 20u);
  EXPECT_GT(linePoints(*page.chart()->plot()), 700) << "a curve for each circle";
}

TEST(FormList, SpeaksChinese) {
  const Speaking speaking(QStringLiteral("zh_CN"));
  Page page("dented-guideway");
  EXPECT_THAT(page.shown(), Not(HasSubstr("The form:")));
  EXPECT_THAT(page.shown(), HasSubstr("0.28"));
}

// Otherwise the wheel could not scroll the page past the chart.
TEST(FormList, LeavesTheWheelToThePage) {
  Page page("dented-guideway");
  FormChart* chart = page.chart();
  ASSERT_TRUE(chart);
  const auto turn = [&](Qt::KeyboardModifiers modifiers) {
    QWidget* view = chart->childAt(chart->rect().center());
    QWheelEvent event(view->rect().center(), view->mapToGlobal(QPointF(view->rect().center())), {}, {0, 120},
                      Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(view, &event);
    return chart->plot()->isZoomed();
  };
  EXPECT_FALSE(turn(Qt::NoModifier));
  EXPECT_TRUE(turn(Qt::ControlModifier));
}

TEST(LeftoverStrips, ShadeWhereTheModelHolds) {
  LeftoverStrips strips;
  strips.resize(600, strips.sizeHint().height());
  strips.setGap(*gapOf("dented-guideway"));
  const std::vector<QRect> bands = strips.bands(0);
  ASSERT_EQ(bands.size(), 2u);
  // Places run from 10° to 170° over some 560 pixels; the dent is seen from 22° to 58°.
  const int dent = bands[1].left() - bands[0].right();
  EXPECT_NEAR(dent, 560 * 36 / 160, 25);
  EXPECT_TRUE(strips.bands(1).empty()) << "there is no form of the elevation";
  strips.setGap(*gapOf("unknown-form"));
  EXPECT_TRUE(strips.bands(0).empty()) << "a harmonic goes on everywhere";
  strips.setGap(*gapOf("settling-tripod"));
  EXPECT_EQ(strips.bands(2).size(), 1u) << "it ends with time";
  EXPECT_EQ(std::ranges::count(strips.numbers(), '\n'), 1 + 272);
}

TEST(LeftoverStrips, LabelTheEndsOfTheirRangeAndZero) {
  LeftoverStrips strips;
  strips.setGap(*gapOf("dented-guideway"));
  for (const int width : {260, 600, 1400}) {
    strips.resize(width, strips.sizeHint().height());
    QRect above;
    for (std::size_t strip = 0; strip < 3; ++strip) {
      const auto [upper, zero, lower] = strips.labels(strip);
      EXPECT_TRUE(upper.text.endsWith(QStringLiteral(" σ"))) << upper.text.toStdString();
      EXPECT_EQ(zero.text, QStringLiteral("0 σ"));
      EXPECT_EQ(lower.text, QChar(0x2212) + upper.text.mid(upper.text.startsWith(u'+') ? 1 : 0));
      for (const auto& label : {upper, zero, lower}) {
        EXPECT_TRUE(strips.rect().contains(label.area)) << label.text.toStdString() << " at " << width;
        EXPECT_EQ(label.area.right(), upper.area.right()) << "flush right";
        EXPECT_GE(label.area.width(), strips.fontMetrics().horizontalAdvance(label.text));
        EXPECT_FALSE(label.area.intersects(above));
        above = label.area;
      }
      EXPECT_NEAR(zero.area.center().y(), (upper.area.center().y() + lower.area.center().y()) / 2.0, 1);
    }
  }
  // The largest residual is inside the labelled range.
  const auto reach =
      strips.accessibleDescription().section(QStringLiteral("at most "), 1).section(u' ', 0, 0);
  EXPECT_TRUE(strips.labels(0)[0].text.contains(reach)) << reach.toStdString();
}

}  // namespace
}  // namespace alidade::ui
