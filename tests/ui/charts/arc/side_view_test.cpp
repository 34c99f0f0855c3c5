#include "ui/charts/arc/side_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/simulation/simulate.h"
#include "tests/ui/support.h"
#include "ui/charts/arc/arc_plot.h"

namespace alidade::ui {
namespace {

SideView& viewOf(SideView& view, const std::optional<CentreOffset>& offset, double side = 200) {
  view.setStyle(printStyle(QStringLiteral("DejaVu Sans")));
  view.setSquare({100, 50, side, side});
  view.setOffset(offset);
  return view;
}

// The theodolite is at the right: Δz towards it goes right, Δd goes up, in one scale.
TEST(SideView, ShowsTheCentreInProportion) {
  SideView view, origin;
  viewOf(view, CentreOffset{.inPlane = 1.5, .across = -6});
  viewOf(origin, CentreOffset{});
  const QPointF away = view.centre() - origin.centre();
  EXPECT_GT(view.scale(), 0);
  EXPECT_DOUBLE_EQ(away.x(), -6 * view.scale());
  EXPECT_DOUBLE_EQ(away.y(), -1.5 * view.scale());
}

TEST(SideView, HoldsBothCentresWithTheirUncertainty) {
  for (const double across : {-6.0, 0.0, 0.01, 80.0})
    for (const double up : {-3.0, 0.0, 40.0})
      for (const double expanded : {0.0, 0.5, 20.0, std::numeric_limits<double>::infinity()})
        for (const std::optional<double> tolerance :
             {std::optional<double>(), std::optional(2.5), std::optional(1e5)}) {
          SideView view;
          viewOf(view, CentreOffset{.inPlane = up,
                                    .inPlaneExpanded = expanded,
                                    .across = across,
                                    .acrossExpanded = expanded,
                                    .tolerance = tolerance,
                                    .isOfDistance = up > 0});
          const QRectF square = view.boundingRect();
          const double reach = std::isfinite(expanded) ? expanded * view.scale() : 0;
          EXPECT_GT(view.scale(), 0);
          EXPECT_TRUE(square.contains(view.centre() + QPointF(reach, reach)));
          EXPECT_TRUE(square.contains(view.centre() - QPointF(reach, reach)));
        }
}

// The names distinguish O1 from O2 without colour.
TEST(SideView, NamesBothCentresWithinThePicture) {
  for (const double across : {-6.0, 0.0, 0.01, 80.0})
    for (const double up : {-3.0, 0.0, 40.0})
      for (const QSizeF& size : {QSizeF(70, 70), QSizeF(200, 200), QSizeF(300, 120)}) {
        SideView view;
        viewOf(view, CentreOffset{.inPlane = up, .across = across});
        view.setSquare(QRectF(QPointF(100, 50), size));
        const QRectF first = view.nameRect(0), second = view.nameRect(180);
        EXPECT_TRUE(view.boundingRect().contains(first)) << up << ", " << across;
        EXPECT_TRUE(view.boundingRect().contains(second)) << up << ", " << across;
        EXPECT_FALSE(size.height() > 100 && first.intersects(second)) << up << ", " << across;
      }
}

TEST(SideView, StatesTheOffsetWhereItHasRoom) {
  SideView view;
  viewOf(view, CentreOffset{.across = -5.9, .acrossExpanded = 1.2}, 400);
  ASSERT_EQ(view.title().size(), 2);
  EXPECT_EQ(view.title().last(), QStringLiteral("Δz = −5.9 ± 1.2 mm"));
  view.setSquare({0, 0, 160, 160});
  EXPECT_EQ(view.title(), QStringList(QStringLiteral("Δz = −5.9 ± 1.2 mm")));
  view.setSquare({0, 0, 100, 100});
  EXPECT_EQ(view.title(), QStringList(QStringLiteral("Along the axis")));
  view.setSquare({0, 0, 60, 60});
  EXPECT_TRUE(view.title().isEmpty());
  EXPECT_GT(view.scale(), 0);
}

TEST(SideView, IsEmptyWithoutMeasurementOrRoom) {
  SideView view;
  EXPECT_EQ(viewOf(view, std::nullopt).scale(), 0);
  EXPECT_EQ(viewOf(view, CentreOffset{.across = 3}, 40).scale(), 0) << "no line of text has room";
  EXPECT_GT(viewOf(view, CentreOffset{.across = 3}).scale(), 0);
}

// Δz of the paper is −5.9 mm: away from the theodolite.
TEST(SideView, KeepsClearOfWhatTheArcsShow) {
  const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(paperSession())));
  for (const QSizeF& size : {QSizeF(700, 500), QSizeF(900, 400), QSizeF(500, 700)}) {
    ArcPlot plot;
    plot.setStyle(printStyle(QStringLiteral("DejaVu Sans")));
    plot.setEvaluation(*gap.evaluation);
    plot.setHeadline(headlineOf(gap));
    plot.arrange(size);
    const QRectF square = plot.sideView().boundingRect();
    EXPECT_TRUE(plot.plotArea().contains(square));
    for (const Mark& mark : plot.markers().marks())
      EXPECT_FALSE(square.contains(plot.sceneFromAxes().map(mark.at) + mark.shift));
    EXPECT_FALSE(square.intersects(plot.inset().boundingRect()));
    if (plot.sideView().scale() > 0) {
      EXPECT_LT(plot.sideView().centre().x(), square.center().x());
    }
  }
  ArcPlot wide;
  wide.setStyle(printStyle(QStringLiteral("DejaVu Sans")));
  wide.setEvaluation(*gap.evaluation);
  wide.setHeadline(headlineOf(gap));
  wide.arrange({700, 500});
  EXPECT_GT(wide.sideView().scale(), 0);
  wide.setHeadline(headlineOf(*gap.evaluation));
  EXPECT_EQ(wide.sideView().scale(), 0) << "while the diagnosis is running nothing is known across";
}

/// Arcs of 270°, which leave little of a corner.
Session longArcs() {
  Protocol protocol = *protocolByName("paper");
  protocol.points = 28;
  protocol.first = Angle::fromDegrees(-45);
  const Result<Session> simulated = simulate(protocol, drawTruth(5), 5);
  if (!simulated) throw std::runtime_error(simulated.problem().text());
  return *simulated;
}

// The inset's headline matters most; the side view must not displace it.
TEST(SideView, TakesNoHeadlineFromTheInset) {
  for (const Session& session : {paperSession(), longArcs()}) {
    const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(session)));
    for (double side = 250; side < 900; side += 50) {
      const auto titlesWith = [&](bool isMeasured) {
        Headline headline = headlineOf(gap);
        if (!isMeasured) headline.offset.reset();
        ArcPlot plot;
        plot.setStyle(printStyle(QStringLiteral("DejaVu Sans")));
        plot.setEvaluation(*gap.evaluation);
        plot.setHeadline(headline);
        plot.arrange({side, side});
        return plot.inset().titleLines().size();
      };
      EXPECT_EQ(titlesWith(true) > 0, titlesWith(false) > 0) << side;
    }
  }
}

TEST(SideView, IsReadableBesideLongArcs) {
  const Gap gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(longArcs())));
  ArcPlot plot;
  plot.setStyle(printStyle(QStringLiteral("DejaVu Sans")));
  plot.setEvaluation(*gap.evaluation);
  plot.arrange({500, 500});
  const QRectF whole = plot.inset().boundingRect();
  plot.setHeadline(headlineOf(gap));
  const QRectF view = plot.sideView().boundingRect(), inset = plot.inset().boundingRect();
  const double line = QFontMetricsF(plot.style().font).height();
  EXPECT_GT(view.width(), 15 * line);
  EXPECT_GT(view.height(), 6 * line);
  EXPECT_EQ(plot.sideView().title().size(), 2) << "with the figure of Δz";
  EXPECT_FALSE(view.intersects(inset));
  EXPECT_TRUE(whole.contains(view) && whole.contains(inset)) << "together they keep clear of the arcs";
  EXPECT_GT(plot.inset().scale(), 0);
}

}  // namespace
}  // namespace alidade::ui
