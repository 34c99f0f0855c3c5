#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/diagnose.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

// The residuals of Table I are 9.375″ and 8.34″ (independent solvers). Slider readings without influence,
// 1800″ wrong at every other visit with σ 3500″, do not change the circles. Their residuals do not count in
// the gap in arcseconds.
TEST(GapSize, RmsIsOfTheCirclesAlone) {
  Session session = test::paperSession();
  session.instrument.sigmaSliderArcsec = "3500";
  for (Position& position : session.positions)
    for (Reading& reading : position.readings) {
      const int point = std::stoi(reading.point);
      reading.slider = std::to_string(10 * point) + (point % 2 == 0 ? ".5°" : "°");
    }
  const Measurement measurement = test::measurementOf(session);
  const double expected = std::sqrt((9.375 * 9.375 + 8.34 * 8.34) / 2);
  EXPECT_NEAR(diagnose(measurement)->gap.rms, expected, 0.05);
  const SessionFit fit = fitSession(measurement);
  EXPECT_NEAR(fit.arcs[0].residualRms, 9.375, 0.01);
  EXPECT_NEAR(fit.arcs[1].residualRms, 8.34, 0.01);
}

}  // namespace
}  // namespace alidade
