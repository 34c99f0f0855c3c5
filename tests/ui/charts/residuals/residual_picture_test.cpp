#include "ui/charts/residuals/residual_picture.h"

#include <gtest/gtest.h>

#include "tests/ui/support.h"
#include "ui/charts/residuals/residual_plot.h"

namespace alidade::ui {
namespace {

TEST(ResidualPicture, HoldsBothCirclesOfEveryRow) {
  const Evaluation evaluation = evaluate(paperSession());
  const ResidualPicture picture = residualPicture(evaluation);
  ASSERT_EQ(picture.residuals.size(), 68u);
  const SightingResidual& first = evaluation.fit.arcs[1].residuals[3];
  const DrawnResidual& horizontal = picture.residuals[34 + 6];
  const DrawnResidual& vertical = picture.residuals[34 + 7];
  EXPECT_EQ(horizontal.ref, (SightingRef{1, 3}));
  EXPECT_EQ(horizontal.circle, CircleRead::Horizontal);
  EXPECT_EQ(vertical.circle, CircleRead::Vertical);
  EXPECT_DOUBLE_EQ(horizontal.arcsec, first.horizontal.arcseconds());
  EXPECT_DOUBLE_EQ(vertical.arcsec, first.vertical.arcseconds());
  EXPECT_DOUBLE_EQ(horizontal.standardised, first.horizontalStandardised);
  EXPECT_DOUBLE_EQ(vertical.standardised, first.verticalStandardised);
}

// The first reading of Table I: 25.19″ with 2″ stated, s0 = 6.912, r = 0.6117.
TEST(ResidualPlot, TellsTheStandardisedResidualOfAReading) {
  ResidualPlot plot;
  plot.setEvaluation(evaluate(paperSession()));
  EXPECT_TRUE(
      plot.describe(plot.markers().marks().front())
          .endsWith(QStringLiteral("horizontal circle: +25.2″ at s = 10.33°, standardised w = +2.33")))
      << plot.describe(plot.markers().marks().front()).toStdString();
}

TEST(ResidualPicture, SharesOneSliderCoordinate) {
  for (const DrawnResidual& residual : residualPicture(evaluate(paperSession())).residuals) {
    // The paper's points are at every 10° from 10° on, at 0° and at 180° alike.
    EXPECT_NEAR(residual.slider, 10 * residual.point, 1.5) << residual.axisDeg;
  }
}

TEST(ResidualPicture, KnowsTheStatedNoise) {
  Session session = paperSession();
  session.instrument.sigmaHorizontalArcsec = "5";
  session.instrument.sigmaVerticalArcsec = "3";
  const ResidualPicture picture = residualPicture(evaluate(session));
  EXPECT_NEAR(picture.sigmaHorizontal, 5, 1e-9);
  EXPECT_NEAR(picture.sigmaVertical, 3, 1e-9);
}

TEST(ResidualPicture, IsEmptyWithoutAFit) {
  EXPECT_TRUE(residualPicture({}).isEmpty());
  EXPECT_TRUE(residualPicture(evaluate(blankSession())).isEmpty());
}

}  // namespace
}  // namespace alidade::ui
