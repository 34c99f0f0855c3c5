#include "ui/charts/arc/centres_inset.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluation/evaluation.h"
#include "tests/ui/support.h"
#include "ui/charts/arc/arc_plot.h"

namespace alidade::ui {
namespace {

PlotStyle insetStyle() {
  return printStyle(QStringLiteral("DejaVu Sans"));
}

/// O1 2 mm above and O2 2 mm below the axis, O2 1 mm to the right; ellipses of 0.6 mm by 0.3 mm.
DrawnIntersection drawnIntersection() {
  const DrawnEllipse ellipse{.major = 0.6, .minor = 0.3, .direction = 0};
  return {.upperCentre = {-0.5, 2},
          .lowerCentre = {0.5, -2},
          .value = 2,
          .expanded = 0.5,
          .upperEllipse = ellipse,
          .lowerEllipse = ellipse};
}

/// An inset of 400 by 400, painted.
struct Painted {
  explicit Painted(const DrawnIntersection& intersection) {
    inset.setStyle(style);
    inset.setSquare({0, 0, 400, 400});
    inset.setIntersection(intersection);
    image.fill(style.background);
    QPainter painter(&image);
    inset.paint(&painter, nullptr, nullptr);
  }
  QPointF at(double x, double y) const { return inset.place({x, y}); }
  bool hasNear(double x, double y, const QColor& colour, int reach = 2) const {
    const QPoint centre = at(x, y).toPoint();
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const QColor found = image.pixelColor(centre + QPoint(dx, dy));
        const int off = std::abs(found.red() - colour.red()) + std::abs(found.green() - colour.green()) +
                        std::abs(found.blue() - colour.blue());
        if (off < 150) return true;
      }
    return false;
  }
  PlotStyle style = insetStyle();
  CentresInset inset;
  QImage image{400, 400, QImage::Format_RGB32};
};

TEST(CentresInset, DrawsTheEllipsesAboutTheCentres) {
  const Painted painted(drawnIntersection());
  for (const double side : {-1, 1}) {
    EXPECT_TRUE(painted.hasNear(-0.5 + side * 0.6, 2, painted.style.upper));
    EXPECT_FALSE(painted.hasNear(-0.5 + side * 0.45, 2, painted.style.upper));
  }
  DrawnIntersection upright = drawnIntersection();
  upright.upperEllipse.direction = M_PI / 3;
  const Painted turned(upright);
  EXPECT_TRUE(
      turned.hasNear(-0.5 + 0.6 * std::cos(M_PI / 3), 2 + 0.6 * std::sin(M_PI / 3), turned.style.upper))
      << "towards y, which is up";
  EXPECT_FALSE(
      turned.hasNear(-0.5 + 0.6 * std::cos(M_PI / 3), 2 - 0.6 * std::sin(M_PI / 3), turned.style.upper));
}

TEST(CentresInset, KeepsTheCentresApartWhateverTheEllipses) {
  const auto apart = [](double major, double minor) {
    DrawnIntersection drawn = drawnIntersection();
    drawn.upperEllipse = drawn.lowerEllipse = {.major = major, .minor = minor, .direction = 0.3};
    const Painted painted(drawn);
    return painted.at(0.5, -2).y() - painted.at(-0.5, 2).y();
  };
  const double usual = apart(0.6, 0.3);
  EXPECT_NEAR(apart(1e-9, 1e-9), usual, 0.1 * usual);
  for (const double huge : {50.0, 1e6, std::numeric_limits<double>::infinity()})
    EXPECT_GT(apart(huge, 0.3), 60);
  EXPECT_GT(apart(1e9, 1e9), 60);
}

TEST(CentresInset, ShowsModerateEllipsesWhole) {
  DrawnIntersection drawn = drawnIntersection();
  drawn.upperEllipse = {.major = 3, .minor = 0.3, .direction = M_PI / 2};
  const Painted painted(drawn);
  EXPECT_GT(painted.at(-0.5, 5).y(), 20);
  EXPECT_TRUE(painted.hasNear(-0.5, 5, painted.style.upper, 3));
}

TEST(CentresInset, MarksWhereClosureWouldWantTheSecondCentre) {
  const Painted painted(drawnIntersection());
  EXPECT_TRUE(painted.hasNear(-0.5, -2, painted.style.mutedText));
  DrawnIntersection closed = drawnIntersection();
  closed.lowerCentre.x = closed.upperCentre.x = 0;
  EXPECT_EQ(closed.closedCentre().x, 0);
  EXPECT_EQ(closed.closedCentre().y, -2);
  EXPECT_FALSE(Painted(closed).hasNear(0, -2, painted.style.mutedText, 3)) << "under the marker of O2";
}

TEST(CentresInset, ShowsWhereTheCentresMayLieAtTheTolerance) {
  const auto colourAt = [](const DrawnIntersection& drawn, double x, double y) {
    const Painted painted(drawn);
    return painted.image.pixelColor(painted.at(x, y).toPoint());
  };
  const PlotStyle style = insetStyle();
  DrawnIntersection drawn = drawnIntersection();
  EXPECT_EQ(colourAt(drawn, -1.5, 1), style.background) << "none is stated";
  drawn.tolerance = 2.4;
  for (const double side : {-1, 1}) {
    EXPECT_EQ(colourAt(drawn, -1.5, side * 2.3), style.outerBand);
    EXPECT_EQ(colourAt(drawn, -1.5, side * 2.6), style.background);
  }
  drawn.tolerance = 30;
  for (const double y : {-2.6, 1.0, 2.6}) EXPECT_EQ(colourAt(drawn, -1.5, y), style.outerBand);
  EXPECT_EQ(Painted(drawn).inset.scale(), Painted(drawnIntersection()).inset.scale())
      << "a wide tolerance does not shrink the centres";
}

TEST(CentresInset, EndsTheBarOfUAtBothEnds) {
  const Painted painted(drawnIntersection());
  // The place is to the right of the bar, where only a cap reaches.
  const auto isDarkBeside = [&](double y) {
    const QPoint beside = painted.at(-0.5, y).toPoint() + QPoint(qRound(3 * painted.style.unit()), 0);
    int darkest = 255;
    for (int dy = -2; dy <= 2; ++dy)
      darkest = std::min(darkest, painted.image.pixelColor(beside + QPoint(0, dy)).lightness());
    return darkest < 180;  // a line between two rows of pixels is grey in both
  };
  EXPECT_TRUE(isDarkBeside(2 + 0.5));
  EXPECT_TRUE(isDarkBeside(2 - 0.5));
  EXPECT_FALSE(isDarkBeside(2 - 0.75));
  EXPECT_FALSE(isDarkBeside(2 + 0.75));
}

// The picture of the arcs is some 210 × 260 in a window of 1024 × 700.
TEST(CentresInset, WritesNoNameOverAnother) {
  DrawnIntersection close = drawnIntersection();  // O1 to the right, its name on the line of the axis
  close.upperCentre = {0.1, 0.05};
  close.lowerCentre = {-0.1, -0.05};
  close.tolerance = 2.5;
  int named = 0, silent = 0;
  for (const DrawnIntersection& intersection : {drawnIntersection(), close})
    for (int side = 70; side <= 400; side += 10) {
      CentresInset inset;
      inset.setStyle(insetStyle());
      inset.setSquare(QRectF(0, 0, side, side));
      inset.setIntersection(intersection);
      if (inset.scale() <= 0) continue;
      const QRectF axis = inset.axisNameRect();
      axis.isEmpty() ? ++silent : ++named;
      EXPECT_FALSE(axis.intersects(inset.upperNameRect())) << side;
      EXPECT_FALSE(axis.intersects(inset.lowerNameRect())) << side;
    }
  EXPECT_GT(named, 20) << "where there is room it has one";
  EXPECT_GT(silent, 0);
}

Headline headlineOfPaper() {
  Headline headline;
  headline.name = "Δd";
  headline.figure = "1.30 ± 0.74 mm";
  headline.tolerance = "tolerance ± 2.5 mm";
  headline.verdict = "Accepted";
  headline.fitOnly = "Δd, fit only: 1.31 ± 0.21 mm";
  headline.isMeasured = true;
  return headline;
}

const CentresInset::TitleLine* titleWith(const CentresInset& inset, const char* text) {
  for (const CentresInset::TitleLine& line : inset.titleLines())
    if (line.text.contains(QString::fromUtf8(text))) return &line;
  return nullptr;
}

/// An inset of `side` by `side` that shows the drawn intersection and this headline.
struct InsetWith : CentresInset {
  InsetWith(const Headline& headline, double side) {
    setStyle(insetStyle());
    setSquare(QRectF(0, 0, side, side));
    setIntersection(drawnIntersection());
    setHeadline(headline);
  }
};

TEST(CentresInset, HasTheMeasuredResultAloneInLargeType) {
  const int small = insetStyle().font.pixelSize();
  int titled = 0;
  for (int side = 60; side <= 600; side += 10) {
    SCOPED_TRACE(side);
    InsetWith inset(headlineOfPaper(), side);
    if (inset.titleLines().isEmpty()) continue;
    ++titled;
    EXPECT_TRUE(inset.titleLines().front().text.startsWith(QStringLiteral("Δd"))) << "first";
    for (const char* part : {"1.30 ± 0.74 mm", "tolerance ± 2.5 mm", "Accepted"}) {
      const CentresInset::TitleLine* line = titleWith(inset, part);
      EXPECT_TRUE(line && line->font.bold()) << part;
    }
    EXPECT_GT(titleWith(inset, "1.30")->font.pixelSize(), small);
    for (const CentresInset::TitleLine& line : inset.titleLines()) {
      EXPECT_LE(QFontMetricsF(line.font).horizontalAdvance(line.text), side);
      if (!line.text.contains(QStringLiteral("fit"))) continue;
      EXPECT_TRUE(line.font.pixelSize() == small && !line.font.bold()) << line.text.toStdString();
    }
  }
  EXPECT_GT(titled, 40) << "from a width of 190 on";
}

TEST(CentresInset, ShowsAConditionOrThatThereIsOne) {
  Headline headline = headlineOfPaper();
  headline.lines.push_back({.kind = Headline::Line::Kind::Jump, .text = "Only if", .isWarning = true});
  int said = 0, marked = 0;
  for (int side = 60; side <= 600; side += 10) {
    InsetWith inset(headline, side);
    const auto* verdict = titleWith(inset, "Accepted");
    if (!verdict) continue;
    const bool isSaid = titleWith(inset, "Only if"), isMarked = verdict->text.contains(u'⚠');
    EXPECT_NE(isSaid, isMarked) << side;
    ++(isSaid ? said : marked);
  }
  EXPECT_GT(said, 20);
  EXPECT_GT(marked, 0);
}

Headline headlineWithLongWarning() {
  Headline headline = headlineOfPaper();
  headline.lines.push_back(
      {.kind = Headline::Line::Kind::Gap,
       .text = "Model and readings disagree; accepted only if the cause is plane offset (72 %), "
               "indistinguishable here from trunnion tilt: the radii differ by 13 σ",
       .isWarning = true});
  return headline;
}

TEST(CentresInset, GivesAWarningTheLinesThatItNeeds) {
  const Headline headline = headlineWithLongWarning();
  const QString warning = QString::fromStdString(headline.lines.back().text);
  int whole = 0, cut = 0, marked = 0;
  qsizetype mostLines = 0;
  for (int side = 60; side <= 600; side += 10) {
    SCOPED_TRACE(side);
    InsetWith inset(headline, side);
    const auto* verdict = titleWith(inset, "Accepted");
    if (!verdict) continue;
    QStringList small;
    for (const CentresInset::TitleLine& line : inset.titleLines())
      if (line.colour == insetStyle().text && !line.font.bold()) small.append(line.text);
    const bool isMarked = verdict->text.contains(u'⚠'), isCut = small.join(u' ') != warning;
    EXPECT_EQ(small.isEmpty(), isMarked);
    EXPECT_EQ(inset.cutWarning(), isCut ? warning : QString());
    EXPECT_GT(inset.scale(), 0) << "the centres stay visible";
    if (!isMarked && isCut) {
      EXPECT_GE(small.size(), 3);
      EXPECT_TRUE(small.back().endsWith(u'…'));
    }
    ++(isMarked ? marked : isCut ? cut : whole);
    mostLines = std::max(mostLines, small.size());
  }
  EXPECT_GT(whole, 20);
  EXPECT_GT(mostLines, 2);
  EXPECT_GT(cut, 0);
  EXPECT_GT(marked, 0);
}

TEST(CentresInset, HasACutWarningInTheToolTip) {
  ArcPlot plot;
  plot.setStyle(screenStyle(QApplication::palette(), QApplication::font()));
  plot.setEvaluation(evaluate(paperSession()));
  plot.setHeadline(headlineWithLongWarning());
  int told = 0, silent = 0;
  for (int side = 250; side <= 1200; side += 50) {
    SCOPED_TRACE(side);
    plot.arrange(QSizeF(side, side));
    const QString tip = plot.tipAt(plot.inset().boundingRect().center());
    EXPECT_EQ(tip.isEmpty(), plot.inset().cutWarning().isEmpty());
    EXPECT_TRUE(tip.isEmpty() || tip.endsWith(QStringLiteral("13 σ"))) << tip.toStdString();
    EXPECT_TRUE(plot.tipAt({1, 1}).isEmpty()) << "outside the inset";
    ++(tip.isEmpty() ? silent : told);
  }
  EXPECT_GT(told, 0);
  EXPECT_GT(silent, 0);
}

TEST(CentresInset, ShowsAProvisionalResultInAnotherColour) {
  InsetWith inset(headlineOfPaper(), 400);
  EXPECT_EQ(titleWith(inset, "1.30")->colour, insetStyle().text);
  const double scale = inset.scale();
  Headline provisional = headlineOfPaper();
  provisional.name = "Δd, fit only";
  provisional.isProvisional = true;
  inset.setHeadline(provisional);
  EXPECT_EQ(titleWith(inset, "1.30")->colour, insetStyle().mutedText);
  EXPECT_TRUE(titleWith(inset, "Provisional"));
  EXPECT_FALSE(titleWith(inset, "Accepted"));
  EXPECT_EQ(inset.scale(), scale) << "the picture stays as it is";
}

TEST(CentresInset, IsThereInASmallPicture) {
  ArcPlot plot;
  plot.setStyle(screenStyle(QApplication::palette(), QApplication::font()));
  plot.setEvaluation(evaluate(paperSession()));
  plot.arrange({208, 262});
  EXPECT_GT(plot.inset().scale(), 0);
  EXPECT_TRUE(plot.plotArea().contains(plot.inset().boundingRect()));
  const DrawnIntersection& drawn = *plot.picture().intersection;
  for (const auto& centre : {drawn.upperCentre, drawn.lowerCentre})
    EXPECT_TRUE(plot.inset().boundingRect().contains(plot.inset().place(centre)));
}

}  // namespace
}  // namespace alidade::ui
