#include "ui/charts/arc/side_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

}  // namespace
}  // namespace alidade::ui
