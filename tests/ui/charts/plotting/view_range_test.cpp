#include "ui/charts/plotting/view_range.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace alidade::ui {
namespace {

const QRectF everything(0, -30, 180, 60);

TEST(ViewRange, KeepsThePointItIsZoomedAbout) {
  ViewRange view;
  QRectF shown = everything;
  const QPointF about(45, 10);
  for (int i = 0; i < 10; ++i) {
    const double across = (about.x() - shown.left()) / shown.width();
    const double up = (about.y() - shown.top()) / shown.height();
    view.zoom({1.25, 1.25}, about, shown, everything);
    shown = view.within(everything, false);
    EXPECT_NEAR((about.x() - shown.left()) / shown.width(), across, 1e-9);
    EXPECT_NEAR((about.y() - shown.top()) / shown.height(), up, 1e-9);
  }
  EXPECT_NEAR(shown.width(), 180 / std::pow(1.25, 10), 1e-9);
  EXPECT_FALSE(view.isWhole());
}

TEST(ViewRange, ZoomedOutItIsTheWholeAgainAndFollowsIt) {
  ViewRange view;
  view.zoom({2, 2}, {100, 0}, everything, everything);
  view.zoom({0.4, 0.4}, {10, 0}, view.within(everything, false), everything);
  EXPECT_TRUE(view.isWhole());
  const QRectF other(-5, -60, 200, 120);
  EXPECT_EQ(view.within(other, false), other);
}

TEST(ViewRange, NeverLeavesTheWhole) {
  ViewRange view;
  view.zoom({4, 4}, everything.center(), everything, everything);
  for (const QPointF by : {QPointF(1000, 0), QPointF(0, -1000), QPointF(-3000, 4000)}) {
    view.move(by, view.within(everything, false), everything);
    EXPECT_TRUE(everything.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(view.within(everything, false)));
    EXPECT_NEAR(view.within(everything, false).width(), 45, 1e-9);
  }
  view.zoom({1e30, 1e30}, everything.center(), view.within(everything, false), everything);
  EXPECT_GT(view.within(everything, false).width(), 1e-4) << "not beyond what numbers can tell apart";
}

TEST(ViewRange, MovesNothingWhereAllIsInSight) {
  ViewRange view;
  view.move({10, 10}, everything, everything);
  EXPECT_EQ(view.within(everything, false), everything);
}

TEST(ViewRange, KeepsEqualScales) {
  ViewRange view;
  view.show(QRectF(10, -2, 3, 8), everything);
  const QRectF shown = view.within(everything, true);
  EXPECT_NEAR(shown.width() / shown.height(), 3, 1e-9);
  EXPECT_TRUE(shown.contains(QPointF(10.01, -1.99)) && shown.contains(QPointF(12.99, 5.99)));
}

TEST(ViewRange, BringsAPointIntoSight) {
  ViewRange view;
  view.zoom({10, 10}, {0, -30}, everything, everything);
  view.include({90, 20}, view.within(everything, false), everything);
  EXPECT_TRUE(view.within(everything, false).contains(QPointF(90, 20)));
  const QRectF before = view.within(everything, false);
  view.include({89, 19}, before, everything);
  EXPECT_EQ(view.within(everything, false), before) << "it is in sight";
}

}  // namespace
}  // namespace alidade::ui
