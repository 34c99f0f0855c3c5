#include "ui/charts/plotting/plot.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QtCharts/QChart>
#include <QtCharts/QValueAxis>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/evaluation/evaluation.h"
#include "tests/ui/support.h"
#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/residuals/residual_plot.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

constexpr QSize sizes[] = {{340, 280}, {360, 300}, {700, 400}, {400, 900}, {1200, 900}};

PlotStyle testStyle() {
  return printStyle(QStringLiteral("DejaVu Sans"));
}

QChart& chartOf(Plot& plot) {
  for (QGraphicsItem* item : plot.scene()->items()) {
    if (auto* chart = dynamic_cast<QChart*>(item)) return *chart;
  }
  throw std::runtime_error("no chart in the scene");
}

QImage rendered(Plot& plot, const QSize& size) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  plot.scene()->render(&painter, QRectF({}, size), QRectF({}, size));
  return image;
}

bool hasColourNear(const QImage& image, const QPointF& at, const QColor& colour) {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      const QColor pixel = image.pixelColor(at.toPoint() + QPoint(dx, dy));
      const int off = std::abs(pixel.red() - colour.red()) + std::abs(pixel.green() - colour.green()) +
                      std::abs(pixel.blue() - colour.blue());
      if (off < 150) return true;
    }
  }
  return false;
}

QStringList legendTexts(const Plot& plot) {
  QStringList texts;
  for (const LegendEntry& entry : plot.legend().entries()) texts.append(entry.text);
  return texts;
}

TEST(ArcPlot, KeepsCirclesRoundAtEverySize) {
  ArcPlot plot;
  plot.setStyle(testStyle());
  plot.setEvaluation(evaluate(paperSession()));
  for (const QSize& size : sizes) {
    plot.arrange(size);
    QCoreApplication::processEvents();
    // Compares with the positions computed by Qt Charts itself.
    QChart& chart = chartOf(plot);
    QAbstractSeries* series = chart.series().front();
    const QPointF origin = chart.mapToPosition({0, 0}, series);
    const double perX = (chart.mapToPosition({100, 0}, series) - origin).x() / 100;
    const double perY = (origin - chart.mapToPosition({0, 100}, series)).y() / 100;
    EXPECT_NEAR(perX / perY, 1, 0.01) << size.width() << " × " << size.height();
    EXPECT_GT(perX * 800, 0.35 * std::min(size.width(), size.height()));  // and fills the available space
  }
}

TEST(ArcPlot, HasOneStepOfTicksWithRoomForItsNumbers) {
  ArcPlot plot;
  plot.setStyle(testStyle());
  plot.setEvaluation(evaluate(paperSession()));
  const QFontMetricsF metrics(plot.style().font);
  for (int size = 300; size < 900; size += 7) {
    plot.arrange(QSize(size, size));
    QCoreApplication::processEvents();
    const auto axes = chartOf(plot).axes(Qt::Horizontal) + chartOf(plot).axes(Qt::Vertical);
    ASSERT_EQ(axes.size(), 2);
    auto *x = qobject_cast<QValueAxis*>(axes[0]), *y = qobject_cast<QValueAxis*>(axes[1]);
    EXPECT_DOUBLE_EQ(x->tickInterval(), y->tickInterval()) << "a square of the grid is one";
    const double apart = plot.plotArea().width() * x->tickInterval() / (x->max() - x->min());
    EXPECT_GT(apart, 1.3 * metrics.horizontalAdvance(numberText(x->min(), 0)))
        << "nearly a third of a number between two of them, at " << size;
    EXPECT_GT(apart, 2.5 * metrics.height()) << size;
  }
}

TEST(Plot, PlacesItsPointsWhereQtChartsPlacesTheAxes) {
  ArcPlot arcs;
  ResidualPlot residuals;
  const Evaluation evaluation = evaluate(paperSession());
  for (Plot* plot : {static_cast<Plot*>(&arcs), static_cast<Plot*>(&residuals)}) {
    plot->setStyle(testStyle());
    plot->setEvaluation(evaluation);
    for (const QSize& size : sizes) {
      plot->arrange(size);
      QCoreApplication::processEvents();
      QChart& chart = chartOf(*plot);
      EXPECT_EQ(chart.plotArea(), plot->plotArea());
      for (const Mark& mark : plot->markers().marks()) {
        const QPointF qt = chart.mapToPosition(mark.at, chart.series().front());
        const QPointF ours = plot->sceneFromAxes().map(mark.at);
        EXPECT_LT(std::hypot(qt.x() - ours.x(), qt.y() - ours.y()), 0.5);
      }
    }
  }
}

TEST(ArcPlot, DrawsTheArcsThroughThePoints) {
  ArcPlot plot;
  const QSize size(700, 500);
  plot.setStyle(testStyle());
  plot.setEvaluation(evaluate(paperSession()));
  plot.arrange(size);
  const QImage image = rendered(plot, size);
  const Circle& circle = plot.picture().arcs[0].circle;
  for (const double degrees : {45.0, 75.0, 104.5, 135.0}) {  // between the points
    const auto [x, y] = targetOnArc(circle.x, circle.y, circle.radius, degrees * M_PI / 180);
    EXPECT_TRUE(hasColourNear(image, plot.sceneFromAxes().map(QPointF(x, y)), plot.style().upper)) << degrees;
  }
  for (const Mark& mark : plot.markers().marks()) {
    if (mark.kind != 0) continue;
    EXPECT_TRUE(hasColourNear(image, plot.sceneFromAxes().map(mark.at), plot.style().upper));
  }
}

TEST(ArcPlot, StatesTheExaggerationItDraws) {
  ArcPlot plot;
  plot.setStyle(testStyle());
  plot.setEvaluation(evaluate(paperSession()));
  EXPECT_TRUE(legendTexts(plot).contains(QStringLiteral("residuals × 200")));
  EXPECT_DOUBLE_EQ(plot.picture().exaggeration, 200);
  ASSERT_EQ(plot.markers().sticks().size(), 34u);
  const DrawnSighting& sighting = plot.picture().sightings[0];
  EXPECT_NEAR(
      plot.markers().sticks()[0].line.length(),
      200 * std::hypot(sighting.sighted.x - sighting.adjusted->x, sighting.sighted.y - sighting.adjusted->y),
      1e-6);
}

TEST(ArcPlot, EnlargesTheCentresInTrueProportion) {
  ArcPlot plot;
  plot.setStyle(testStyle());
  const Evaluation evaluation = evaluate(paperSession());
  plot.setEvaluation(evaluation);
  plot.arrange({700, 500});
  const DrawnIntersection& drawn = *plot.picture().intersection;
  const CentresInset& inset = plot.inset();
  ASSERT_GT(inset.scale(), 0);
  const QPointF away = inset.place(drawn.upperCentre) - inset.place(drawn.lowerCentre);
  EXPECT_NEAR(-away.y(), 2 * evaluation.fit.intersection->value * inset.scale(), 1e-6);
  EXPECT_NEAR(away.x(), (drawn.upperCentre.x - drawn.lowerCentre.x) * inset.scale(), 1e-6);
  EXPECT_TRUE(inset.boundingRect().contains(inset.place(drawn.upperCentre)));
  for (const Mark& mark : plot.markers().marks())
    EXPECT_FALSE(inset.boundingRect().contains(plot.sceneFromAxes().map(mark.at)));
}

TEST(ArcPlot, KeepsTheCentresInsideItsFrame) {
  Session session = paperSession();
  for (Position& position : session.positions)  // far above and below the centres, none at their height
    position.readings = {position.readings.begin() + 6, position.readings.begin() + 10};
  ArcPlot plot;
  plot.setStyle(testStyle());
  plot.setEvaluation(evaluate(session));
  for (const QSize& size : sizes) {
    plot.arrange(size);
    EXPECT_TRUE(plot.plotArea().contains(plot.inset().boundingRect())) << size.width();
  }
}

TEST(ArcPlot, SaysWhenThereIsNothingToDraw) {
  ArcPlot plot;
  plot.setStyle(testStyle());
  plot.setEvaluation({});
  plot.arrange({400, 300});
  EXPECT_FALSE(plot.message().isEmpty());
  EXPECT_EQ(plot.markers().marks().size(), 0u);
  EXPECT_TRUE(legendTexts(plot).isEmpty());
  plot.setEvaluation(evaluate(paperSession()));
  EXPECT_TRUE(plot.message().isEmpty());
  plot.setEvaluation({});
  EXPECT_FALSE(plot.message().isEmpty());
  EXPECT_FALSE(plot.picture().intersection);
}

TEST(ResidualPlot, TellsFourKindsApartWithoutColour) {
  ResidualPlot plot;
  plot.setStyle(testStyle());
  plot.setEvaluation(evaluate(paperSession()));
  EXPECT_EQ(plot.markers().marks().size(), 68u);
  std::vector<std::pair<MarkerShape, bool>> kinds;
  for (const LegendEntry& entry : plot.legend().entries()) {
    if (const auto* marker = std::get_if<Marker>(&entry.sign))
      kinds.emplace_back(marker->shape, marker->filled);
  }
  ASSERT_EQ(kinds.size(), 4u);
  std::sort(kinds.begin(), kinds.end());
  EXPECT_EQ(std::unique(kinds.begin(), kinds.end()), kinds.end());
}

TEST(Plot, TellsWhatIsMeasuredAgainByRingsAndInWords) {
  const Evaluation evaluation = evaluate(sessionTakenAt({0, 180, 180, 180}));
  ArcPlot arcs;
  ResidualPlot residuals;
  for (Plot* plot : {static_cast<Plot*>(&arcs), static_cast<Plot*>(&residuals)}) {
    plot->setStyle(testStyle());
    plot->setEvaluation(evaluation);
    std::vector<Marker> markers;
    for (const LegendEntry& entry : plot->legend().entries()) {
      const auto* marker = std::get_if<Marker>(&entry.sign);
      if (!marker) continue;
      EXPECT_EQ(marker->ringed, entry.text.contains(QStringLiteral("again"))) << entry.text.toStdString();
      for (const Marker& other : markers) EXPECT_FALSE(other == *marker);
      markers.push_back(*marker);
    }
    EXPECT_TRUE(plot->describe(plot->markers().marks().back())
                    .startsWith(QStringLiteral("Axis at 180° again (3), point 17,")))
        << plot->describe(plot->markers().marks().back()).toStdString();
    EXPECT_TRUE(
        plot->describe(plot->markers().marks().front()).startsWith(QStringLiteral("Axis at 0°, point 1,")));
  }
  EXPECT_EQ(legendTexts(arcs).mid(0, 3),
            QStringList({QStringLiteral("arc at 0°"), QStringLiteral("arc at 180°"),
                         QStringLiteral("arc at 180° again")}));
  EXPECT_EQ(legendTexts(residuals).mid(0, 6),
            QStringList({QStringLiteral("0° horizontal"), QStringLiteral("0° vertical"),
                         QStringLiteral("180° horizontal"), QStringLiteral("180° vertical"),
                         QStringLiteral("180° again horizontal"), QStringLiteral("180° again vertical")}));
}

// Many marks are copied from a pixmap, including their rings.
TEST(Plot, RingsManyMarksAsFew) {
  Marker marker = testStyle().marker(180, MarkerShape::Diamond, 2);
  const double reach = markerPath(marker.shape, marker.size * 1.9).boundingRect().width() / 2;
  std::vector<QImage> images;
  for (const std::size_t count : {std::size_t{1}, std::size_t{1000}}) {
    MarkerLayer layer;
    layer.setMarkers({marker});
    layer.setMarks(std::vector<Mark>(count, Mark{{20, 20}, 0, {}}));
    layer.setFrame({0, 0, 40, 40}, {});
    QImage image(40, 40, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    layer.paint(&painter, nullptr, nullptr);
    painter.end();
    for (const QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
      EXPECT_TRUE(hasColourNear(image, QPointF(20, 20) + way * (reach - 0.5), marker.colour)) << count;
  }
}

TEST(ResidualPlot, StatesTheNoiseItsBandShows) {
  ResidualPlot plot;
  const QSize size(700, 400);
  plot.setStyle(testStyle());
  plot.arrange(size);
  plot.setEvaluation(evaluate(paperSession()));
  EXPECT_TRUE(legendTexts(plot).contains(QStringLiteral("±1σ, stated σ = 2″")));
  const QImage image = rendered(plot, size);
  const auto at = [&](double s, double arcsec) { return plot.sceneFromAxes().map(QPointF(s, arcsec)); };
  EXPECT_TRUE(hasColourNear(image, at(5, 1), plot.style().band));
  EXPECT_FALSE(hasColourNear(image, at(5, 4), plot.style().limit));
  Session session = paperSession();
  session.instrument.sigmaVerticalArcsec = "5";
  plot.setEvaluation(evaluate(session));
  EXPECT_TRUE(legendTexts(plot).contains(QStringLiteral("±1σ horizontal, stated σ = 2″")));
  EXPECT_TRUE(legendTexts(plot).contains(QStringLiteral("±1σ vertical, stated σ = 5″")));
}

TEST(ResidualPlot, LeavesItsTitlesOutWhereTheAxesNeedTheRoom) {
  ResidualPlot plot;
  plot.setStyle(testStyle());
  plot.setEvaluation(evaluate(paperSession()));
  const auto titled = [&](double height) {
    plot.arrange(QSizeF(520, height));
    const auto axes = chartOf(plot).axes();
    EXPECT_FALSE(axes.isEmpty());
    return std::ranges::all_of(axes, [](const QAbstractAxis* axis) { return axis->isTitleVisible(); });
  };
  EXPECT_TRUE(titled(300));
  const double share = plot.plotArea().height() / 300;
  EXPECT_FALSE(titled(120));
  EXPECT_GT(plot.plotArea().height() / 120, 0.5 * share) << "what is left is not given to words";
  EXPECT_TRUE(titled(300));
}

TEST(ResidualPlot, DrawsTheLineOfZeroUnderReadingsAlone) {
  ResidualPlot plot;
  const QSize size(700, 400);
  plot.setStyle(testStyle());
  plot.arrange(size);
  const auto isBlankAtZero = [&] {
    const QPoint at = plot.sceneFromAxes().map(QPointF(5, 0)).toPoint();  // clear of points and message
    const QImage image = rendered(plot, size);
    const auto isBlank = [&](int dy) { return image.pixelColor(at + QPoint(0, dy)) == QColor(Qt::white); };
    return isBlank(-1) && isBlank(0) && isBlank(1);
  };
  plot.setEvaluation({});
  EXPECT_TRUE(isBlankAtZero());
  plot.setEvaluation(evaluate(paperSession()));
  EXPECT_FALSE(isBlankAtZero());
  plot.setEvaluation({});
  EXPECT_TRUE(isBlankAtZero());
}

TEST(ResidualPlot, ShowsEveryResidual) {
  ResidualPlot plot;
  plot.setStyle(testStyle());
  plot.arrange({700, 400});
  Session session = paperSession();
  session.positions[0].readings[8].vertical = "81°29'30\"";  // an error of one degree
  plot.setEvaluation(evaluate(session));
  for (const Mark& mark : plot.markers().marks()) {
    EXPECT_TRUE(plot.plotArea().contains(plot.sceneFromAxes().map(mark.at)));
  }
}

TEST(Legend, WrapsRatherThanCutsOff) {
  Legend legend;
  legend.setStyle(testStyle());
  std::vector<LegendEntry> entries(8, LegendEntry{testStyle().upper, QStringLiteral("some explanation")});
  legend.setEntries(entries);
  const double wide = legend.layOut(2000), narrow = legend.layOut(250);
  EXPECT_GT(narrow, 2 * wide);
}

}  // namespace
}  // namespace alidade::ui
