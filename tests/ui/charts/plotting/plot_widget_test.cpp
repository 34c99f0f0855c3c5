#include "ui/charts/plotting/plot_widget.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QGraphicsView>
#include <QHelpEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include "core/base/angle_text.h"
#include "core/evaluation/evaluation.h"
#include "tests/ui/support.h"
#include "ui/charts/arc/arc_chart.h"
#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/charts/residuals/residual_plot.h"

namespace alidade::ui {
namespace {

/// The paper's points repeated with a scatter of 20″: `rows` rows in each position.
Session longSession(int rows) {
  Session session = paperSession();
  for (Position& position : session.positions) {
    const std::vector<Reading> base = position.readings;
    position.readings.clear();
    for (int i = 0; i < rows; ++i) {
      Reading reading = base[static_cast<std::size_t>(i) % base.size()];
      const auto moved = [i](const std::string& text, int prime) {
        return formatDms(*parseAngle(text) + Angle::fromArcseconds(i * prime % 41 - 20), 0,
                         AngleSigns::Typewriter);
      };
      reading.horizontal = moved(reading.horizontal, 7919);
      reading.vertical = moved(reading.vertical, 6007);
      reading.round = std::to_string(i / static_cast<int>(base.size()) + 1);
      position.readings.push_back(reading);
    }
  }
  return session;
}

QWidget* viewportOf(PlotWidget& widget) {
  return widget.findChild<QGraphicsView*>()->viewport();
}

template <typename Chart>
class PlotWidgetTest : public ::testing::Test {};
using Charts = ::testing::Types<ArcChart, ResidualChart>;
TYPED_TEST_SUITE(PlotWidgetTest, Charts);

TYPED_TEST(PlotWidgetTest, HandsOnAClickOnAPoint) {
  TypeParam chart;
  chart.resize(700, 500);
  chart.setEvaluation(evaluate(paperSession()));
  chart.show();
  QSignalSpy activated(&chart, &PlotWidget::sightingActivated);
  const Mark mark = chart.plot()->markers().marks().back();
  const QPoint at = chart.plot()->sceneFromAxes().map(mark.at).toPoint();
  QTest::mouseClick(viewportOf(chart), Qt::LeftButton, {}, at);
  ASSERT_EQ(activated.count(), 1);
  EXPECT_EQ(activated[0][0].template value<std::size_t>(), mark.ref.position);
  EXPECT_EQ(activated[0][1].template value<std::size_t>(), mark.ref.row);
  QTest::mouseClick(viewportOf(chart), Qt::LeftButton, {}, QPoint(3, 3));
  EXPECT_EQ(activated.count(), 1);
}

// When the mouse rests, Qt asks the scene for a tip, 0.7 s after the chart has shown its own tip.
TYPED_TEST(PlotWidgetTest, KeepsTheTipOfAPointWhileTheMouseRests) {
  TypeParam chart;
  chart.resize(700, 500);
  chart.setEvaluation(evaluate(paperSession()));
  chart.show();
  const Mark mark = chart.plot()->markers().marks().back();
  const QPoint at = chart.plot()->sceneFromAxes().map(mark.at).toPoint();
  QWidget* viewport = viewportOf(chart);
  QTest::mouseMove(viewport, at);
  ASSERT_TRUE(waitFor([] { return QToolTip::isVisible(); }));
  EXPECT_EQ(QToolTip::text(), chart.plot()->describe(mark));
  QHelpEvent rests(QEvent::ToolTip, at, viewport->mapToGlobal(at));
  QCoreApplication::sendEvent(viewport, &rests);
  QTest::qWait(500);  // a tip that is hidden stays for 300 ms
  EXPECT_TRUE(QToolTip::isVisible());
  QTest::mouseMove(viewport, QPoint(3, 3));
  EXPECT_TRUE(waitFor([] { return !QToolTip::isVisible(); })) << "there is no point";
}

TYPED_TEST(PlotWidgetTest, EnlargesTheHighlightedRow) {
  TypeParam chart;
  chart.resize(700, 500);
  chart.setEvaluation(evaluate(paperSession()));
  const QImage before = chart.grab().toImage();
  chart.setHighlighted(0, 5);
  const QImage highlighted = chart.grab().toImage();
  EXPECT_NE(highlighted, before);
  chart.clearHighlight();
  EXPECT_EQ(chart.grab().toImage(), before);
}

TYPED_TEST(PlotWidgetTest, FollowsThePalette) {
  TypeParam chart;
  chart.resize(500, 400);
  chart.setEvaluation(evaluate(paperSession()));
  EXPECT_GT(chart.grab().toImage().pixelColor(2, 390).lightness(), 200);
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(0x1e, 0x1f, 0x22));
  dark.setColor(QPalette::Text, QColor(0xdf, 0xe1, 0xe5));
  chart.setPalette(dark);
  const QImage image = chart.grab().toImage();
  EXPECT_EQ(image.pixelColor(2, 390), QColor(0x1e, 0x1f, 0x22));
  EXPECT_GT(chart.plot()->style().upper.lightness(), 100);
}

TYPED_TEST(PlotWidgetTest, DescribesEveryPointInWords) {
  TypeParam chart;
  chart.resize(700, 500);
  chart.setEvaluation(evaluate(paperSession()));
  for (const Mark& mark : chart.plot()->markers().marks()) {
    const QString text = chart.plot()->describe(mark);
    EXPECT_TRUE(text.contains(QStringLiteral("point %1,").arg(mark.ref.row + 1))) << text.toStdString();
    EXPECT_TRUE(text.contains(mark.ref.position == 0 ? QStringLiteral("0°") : QStringLiteral("180°")));
  }
  EXPECT_FALSE(chart.accessibleName().isEmpty());
  EXPECT_FALSE(chart.accessibleDescription().isEmpty());
}

TYPED_TEST(PlotWidgetTest, TakesTenThousandRows) {
  const Evaluation evaluation = evaluate(longSession(5000));
  ASSERT_TRUE(evaluation.fit.intersection);
  TypeParam chart;
  chart.resize(700, 500);
  QElapsedTimer clock;
  clock.start();
  chart.setEvaluation(evaluation);
  const QImage image = chart.grab().toImage();
  // A scatter series takes seconds; this takes some 15 ms. The limit allows for slow and busy machines.
  EXPECT_LT(clock.elapsed(), 1000);
  EXPECT_GE(chart.plot()->markers().marks().size(), 10000u);
  EXPECT_FALSE(image.isNull());
}

TYPED_TEST(PlotWidgetTest, ComesBackFromEmpty) {
  TypeParam chart;
  chart.resize(500, 400);
  chart.show();
  EXPECT_FALSE(chart.plot()->message().isEmpty());
  const QImage empty = chart.grab().toImage();
  chart.setEvaluation(evaluate(paperSession()));
  EXPECT_NE(chart.grab().toImage(), empty);
  chart.setHighlighted(7, 7);  // a missing row
  chart.setEvaluation({});
  chart.grab();
  EXPECT_TRUE(chart.plot()->markers().marks().empty());
}

}  // namespace
}  // namespace alidade::ui
