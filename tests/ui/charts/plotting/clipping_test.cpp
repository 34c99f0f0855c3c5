#include "ui/charts/plotting/clipping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace alidade::ui {
namespace {

const QRectF clipFrame(-10, -5, 20, 10);

TEST(Clipping, KeepsWhatLiesInside) {
  const QLineF line(-3, 1, 4, 2);
  EXPECT_EQ(clipped(line, clipFrame), line);
  const QList<QPointF> curve{{0, 0}, {1, 1}, {2, 0}};
  EXPECT_EQ(clipped(curve, clipFrame), QList<QList<QPointF>>{curve});
}

// Compares with points sampled along the line.
TEST(Clipping, CutsAnyLineWhereItLeaves) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-30, 30);
  int cut = 0;
  for (int i = 0; i < 2000; ++i) {
    const QLineF line(at(random), at(random), at(random), at(random));
    const auto part = clipped(line, clipFrame);
    constexpr int steps = 400;
    int inside = 0;
    for (int step = 0; step <= steps; ++step)
      inside += clipFrame.contains(line.pointAt(step / double{steps})) ? 1 : 0;
    const double share = part ? part->length() / line.length() : 0;
    EXPECT_NEAR(share, inside / (steps + 1.0), 2.0 / steps);
    cut += part ? 1 : 0;
    if (part) {
      EXPECT_TRUE(clipFrame.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(part->p1()));
      EXPECT_TRUE(clipFrame.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(part->p2()));
    }
  }
  EXPECT_GT(cut, 200);
}

TEST(Clipping, ACircleAroundTheFrameLeavesItsPieces) {
  QList<QPointF> circle;
  for (int i = 0; i <= 3600; ++i)
    circle.append({8 * std::cos(i * M_PI / 1800), 8 * std::sin(i * M_PI / 1800)});
  const auto pieces = clipped(circle, clipFrame);
  ASSERT_EQ(pieces.size(), 3) << "it starts inside, at the right, and ends there";
  for (const auto& piece : pieces)
    for (const QPointF& point : piece) EXPECT_LE(std::abs(point.y()), 5 + 1e-9);
}

TEST(Clipping, WhatIsNotFiniteIsNotDrawn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(clipped(QLineF(0, 0, nan, 1), clipFrame));
  EXPECT_FALSE(clipped(QLineF(0, 0, std::numeric_limits<double>::infinity(), 1), clipFrame));
}

}  // namespace
}  // namespace alidade::ui
