#include "ui/charts/plotting/thinning.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include "ui/charts/plotting/marker_layer.h"

namespace alidade::ui {
namespace {

const QRectF area(0, 0, 800, 250);
const Raster raster{area, 3.5};

/// x in 0…1, y in −1…1 of the axes.
QTransform sceneFromAxes() {
  QTransform transform;
  transform.translate(0, 125);
  transform.scale(800, -120);
  return transform;
}

std::vector<Mark> noise(std::size_t count, std::size_t kinds = 4) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 0.2);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Mark> marks;
  for (std::size_t i = 0; i < count; ++i)
    marks.push_back({{uniform(random), std::clamp(normal(random), -0.9, 0.9)}, i % kinds, {0, i}});
  return marks;
}

bool isAmong(const std::vector<PlacedMark>& placed, const Mark& mark) {
  const QPointF at = sceneFromAxes().map(mark.at);
  return std::any_of(placed.begin(), placed.end(),
                     [&](const PlacedMark& one) { return one.at == at && one.kind == mark.kind; });
}

TEST(Thinning, LeavesFewAsTheyAre) {
  const std::vector<Mark> marks = noise(3000);
  EXPECT_EQ(thinned(marks, sceneFromAxes(), raster).size(), marks.size());
}

TEST(Thinning, CostsByThePlotAndNotByTheReadings) {
  const std::size_t cells = 229 * 72;
  const auto some = thinned(noise(50000), sceneFromAxes(), raster).size();
  const auto many = thinned(noise(1000000), sceneFromAxes(), raster).size();
  EXPECT_LE(many, 2 * 4 * cells);
  EXPECT_LT(static_cast<double>(many), 5.0 * static_cast<double>(some)) << "twenty times as many marks";
}

/// The highest and lowest marks of each kind, and all isolated marks, are painted.
TEST(Thinning, AlwaysPaintsWhatStandsOut) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::vector<Mark> marks = noise(20000);
    std::mt19937 random(seed);
    for (const double y : {0.99, -0.97, 0.95})
      marks[random() % marks.size()].at = {static_cast<double>(random() % 1000) / 1000, y};
    const auto placed = thinned(marks, sceneFromAxes(), raster);
    ASSERT_LT(placed.size(), marks.size());
    const auto isLower = [](const Mark& a, const Mark& b) { return a.at.y() < b.at.y(); };
    for (std::size_t kind = 0; kind < 4; ++kind) {
      std::vector<Mark> ofKind;
      std::copy_if(marks.begin(), marks.end(), std::back_inserter(ofKind),
                   [&](const Mark& mark) { return mark.kind == kind; });
      EXPECT_TRUE(isAmong(placed, *std::max_element(ofKind.begin(), ofKind.end(), isLower)));
      EXPECT_TRUE(isAmong(placed, *std::min_element(ofKind.begin(), ofKind.end(), isLower)));
    }
    for (const Mark& mark : marks) {
      if (std::abs(mark.at.y()) > 0.92) {
        EXPECT_TRUE(isAmong(placed, mark));
      }
    }
  }
}

TEST(Thinning, KeepsTheLongestSticksBothWays) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal(0, 0.1);
  std::vector<Stick> sticks;
  for (std::size_t i = 0; i < 20000; ++i) {
    const double x = static_cast<double>(i % 17) / 17;
    sticks.push_back({QLineF(x, 0, x, normal(random)), i % 2});
  }
  sticks[777].line.setP2({sticks[777].line.x1(), 0.9});
  sticks[778].line.setP2({sticks[778].line.x1(), -0.9});
  const auto placed = thinned(sticks, sceneFromAxes(), raster);
  EXPECT_LE(placed.size(), 17u * 2 * 8);
  for (const std::size_t far : {777, 778}) {
    const QLineF line = sceneFromAxes().map(sticks[far].line);
    EXPECT_TRUE(
        std::any_of(placed.begin(), placed.end(), [&](const Stick& one) { return one.line == line; }));
  }
}

TEST(Thinning, BearsWhatIsNowhere) {
  std::vector<Stick> sticks(2000);
  sticks[0].line = QLineF(NAN, NAN, 1, 1);
  sticks[1].line = QLineF(-1e300, 1e300, INFINITY, -INFINITY);
  EXPECT_LE(thinned(sticks, sceneFromAxes(), raster).size(), 10u);
  std::vector<Mark> marks = noise(20000);
  marks[0].at = {NAN, 0};
  marks[1].at = {INFINITY, 0};
  EXPECT_FALSE(isAmong(thinned(marks, sceneFromAxes(), raster), marks[1]));
}

/// The number of painted pixels, and their highest and lowest row.
struct Ink {
  int pixels = 0, top = 250, bottom = 0;
};

Ink inkOf(std::vector<Mark> marks, std::size_t layers) {
  QImage image(800, 250, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::white);
  QPainter painter(&image);
  const std::size_t share = (marks.size() + layers - 1) / layers;
  for (std::size_t first = 0; first < marks.size(); first += share) {
    MarkerLayer layer;
    layer.setMarkers(std::vector<Marker>(4, {MarkerShape::Circle, Qt::black, Qt::white, true, 7}));
    layer.setFrame(area, sceneFromAxes());
    const auto from = marks.begin() + static_cast<std::ptrdiff_t>(first);
    layer.setMarks({from, from + static_cast<std::ptrdiff_t>(std::min(share, marks.size() - first))});
    layer.paint(&painter, nullptr, nullptr);
  }
  painter.end();
  Ink ink;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      if (qGray(image.pixel(x, y)) > 128) continue;
      ++ink.pixels;
      ink.top = std::min(ink.top, y);
      ink.bottom = std::max(ink.bottom, y);
    }
  return ink;
}

/// Painting in pieces shows the same marks.
TEST(Thinning, LooksAsIfAllWerePainted) {
  const std::vector<Mark> marks = noise(30000);
  const Ink all = inkOf(marks, 10), few = inkOf(marks, 1);
  EXPECT_EQ(few.top, all.top);
  EXPECT_EQ(few.bottom, all.bottom);
  EXPECT_NEAR(few.pixels, all.pixels, 0.01 * all.pixels);
}

}  // namespace
}  // namespace alidade::ui
