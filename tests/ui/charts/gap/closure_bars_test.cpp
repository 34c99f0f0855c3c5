#include "ui/charts/gap/closure_bars.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPalette>

#include "tests/ui/support.h"
#include "ui/charts/plotting/plot_style.h"

namespace alidade::ui {
namespace {

constexpr double k = 1.959964;  // 95 % of the normal distribution

Closure closureOf(Closure::Of of, double inU, double sigma) {
  return {.of = of, .value = inU * k * sigma, .sigma = sigma};
}

/// Three closures: at 1.5 U; at 30 U, reduced to −0.5 U by the causes; at −2 U with a much larger σ.
Gap drawnGap() {
  Gap gap{.evaluation = std::make_shared<const Evaluation>(evaluateFit(paperSession())),
          .diagnosis = Diagnosis{},
          .reason = {},
          .stages = {}};
  gap.diagnosis->causes.push_back(
      {.effect = "plane_offset", .parameters = {}, .indistinguishableFrom = {}, .readings = {}});
  gap.diagnosis->closures = {{.before = closureOf(Closure::Of::Radius, 1.5, 0.2)},
                             {.before = closureOf(Closure::Of::Centre, 30, 0.01),
                              .after = closureOf(Closure::Of::Centre, -0.5, 0.01)},
                             {.before = closureOf(Closure::Of::Reference, -2, 5)}};
  return gap;
}

struct Drawn {
  explicit Drawn(const Gap& gap) {
    bars.setGap(gap);
    bars.resize(400, bars.sizeHint().height());
    image = bars.grab().toImage().convertToFormat(QImage::Format_RGB32);
    style = screenStyle(bars.palette(), bars.font());
  }
  /// The colour at `inU` on the strip of closure `row`, at the share `down` of its height from the top.
  QColor at(std::size_t row, double inU, double down) const {
    const QRect strip = bars.strip(row);
    const double scale = image.width() / 400.0;
    return image.pixelColor(static_cast<int>(bars.x(inU) * scale),
                            static_cast<int>((strip.top() + down * strip.height()) * scale));
  }
  ClosureBars bars;
  QImage image;
  PlotStyle style;
};

TEST(ClosureBars, ReachFromZeroToTheMisclosureInItsOwnU) {
  const Drawn drawn(drawnGap());
  EXPECT_EQ(drawn.at(0, 1.3, 0.5), drawn.style.upper);
  EXPECT_EQ(drawn.at(0, 1.7, 0.5), drawn.style.grid);
  EXPECT_EQ(drawn.at(2, -1.8, 0.5), drawn.style.upper);
  EXPECT_EQ(drawn.at(2, -2.2, 0.5), drawn.style.grid);
  EXPECT_EQ(drawn.at(2, 0.3, 0.5), drawn.style.band) << "towards its own sign alone";
}

TEST(ClosureBars, StandBeforeTheBandOfU) {
  const Drawn drawn(drawnGap());
  for (std::size_t row = 0; row < 3; ++row)
    for (const double side : {-1, 1}) {
      EXPECT_EQ(drawn.at(row, side * 0.9, 0.1), drawn.style.band) << row;
      EXPECT_EQ(drawn.at(row, side * 1.1, 0.1), drawn.style.grid) << row;
    }
}

TEST(ClosureBars, EndInAnArrowBeyondTheScale) {
  const Drawn drawn(drawnGap());
  EXPECT_EQ(drawn.bars.x(30), drawn.bars.x(ClosureBars::scaleEnd));
  EXPECT_EQ(drawn.at(1, 3.9, 0.5), drawn.style.upper);
  const auto isWide = [&](double from, double to) {
    for (double inU = from; inU < to; inU += 0.01)
      if (drawn.at(1, inU, 0.2) == drawn.style.upper) return true;
    return false;
  };
  EXPECT_TRUE(isWide(3.7, 4)) << "wider than the bar";
  EXPECT_FALSE(isWide(0.1, 3.5));
}

TEST(ClosureBars, MarkWhereTheClosureIsWithTheCauses) {
  const auto isMarked = [](const Drawn& drawn, std::size_t row) {
    for (double inU = -0.8; inU < -0.2; inU += 0.01)
      if (drawn.at(row, inU, 0.5) == drawn.style.lower) return true;
    return false;
  };
  Gap gap = drawnGap();
  EXPECT_TRUE(isMarked(Drawn(gap), 1));
  EXPECT_FALSE(isMarked(Drawn(gap), 0));
  gap.diagnosis->causes.clear();
  EXPECT_FALSE(isMarked(Drawn(gap), 1)) << "there are none";
}

TEST(ClosureBars, SayTheirFigures) {
  const Drawn drawn(drawnGap());
  EXPECT_EQ(
      drawn.bars.accessibleDescription(),
      QStringLiteral("R(180°) − R(0°) = 0.59 ± 0.39 mm, 2.9 σ. Δx(180°) − Δx(0°) = 0.588 ± 0.020 mm, 58.8 "
                     "σ; with the causes −0.010 ± 0.020 mm, 1.0 σ. Δd − reference = −19.6 ± 9.8 mm, 3.9 "
                     "σ"));
}

TEST(ClosureBars, AreDrawnInTheColoursOfTheTheme) {
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(0x20, 0x20, 0x20));
  dark.setColor(QPalette::Text, Qt::white);
  const Drawn light(drawnGap());
  Drawn turned(drawnGap());
  turned.bars.setPalette(dark);
  turned.image = turned.bars.grab().toImage().convertToFormat(QImage::Format_RGB32);
  turned.style = screenStyle(dark, turned.bars.font());
  EXPECT_EQ(turned.at(0, 0.9, 0.1), turned.style.band);
  EXPECT_NE(turned.at(0, 0.9, 0.1), light.at(0, 0.9, 0.1));
}

TEST(ClosureBars, AreAbsentWithoutClosures) {
  Gap gap = drawnGap();
  ClosureBars bars;
  bars.setGap(gap);
  EXPECT_FALSE(bars.isEmpty());
  EXPECT_GT(bars.sizeHint().height(), 0);
  gap.diagnosis->closures.clear();
  bars.setGap(gap);
  EXPECT_TRUE(bars.isEmpty());
  EXPECT_EQ(bars.sizeHint().height(), 0);
  EXPECT_TRUE(bars.accessibleDescription().isEmpty());
}

TEST(ClosureBars, TellTheirFiguresAtEveryPointOfTheirRows) {
  struct Bars : ClosureBars {
    using ClosureBars::aboutAt;
  } bars;
  bars.setGap(drawnGap());
  bars.resize(400, bars.sizeHint().height());
  EXPECT_TRUE(bars.aboutAt({200, 0}).startsWith(QStringLiteral("R(180°) − R(0°)")))
      << "the first line of all";
  EXPECT_TRUE(bars.aboutAt({200, bars.strip(0).bottom()}).startsWith(QStringLiteral("R(180°) − R(0°)")));
  EXPECT_TRUE(bars.aboutAt({200, bars.strip(0).bottom() + 1}).isEmpty()) << "between two rows";
  EXPECT_TRUE(bars.aboutAt(bars.strip(1).center()).contains(QStringLiteral("with the causes")));
  EXPECT_TRUE(bars.aboutAt({200, bars.height() - 1}).isEmpty()) << "the scale";
}

}  // namespace
}  // namespace alidade::ui
