#include "core/diagnosis/gap/held_out.h"
#include "core/diagnosis/diagnose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

Measurement read(const std::string& protocol, const Truth& truth, std::uint64_t seed = 3) {
  return test::measurementOf(*simulate(*protocolByName(protocol), truth, seed));
}

/// Returns the model with added terms, each known to `priorSigma`.
GapModel with(const GapModel& model, const std::vector<ErrorTerm>& terms, double priorSigma) {
  GapModel more = model;
  for (const ErrorTerm term : terms) more.options.terms.push_back({term, priorSigma});
  more.refit();
  return more;
}

/// Returns the rms of the circle readings, arcseconds; a complete new fit of the other visits predicts each
/// fifth of the visits.
double rmsOfRefits(const GapModel& model) {
  std::vector<Circle> circles;
  for (std::size_t arc = 0; arc < model.measurement->arcs.size(); ++arc)
    circles.push_back(model.fit->circleOf(arc));
  const Linearised all = linearise(*model.measurement, *model.fit, model.options, {});
  double sum = 0;
  int count = 0;
  for (std::size_t fold = 0; fold < 5; ++fold) {
    JointFitOptions options = model.options;
    for (const LinearReading& reading : all.readings)
      if (reading.visit % 5 == fold) options.without.push_back({reading.arc, reading.sighting, reading.kind});
    const JointFit fit = fitJointly(*model.measurement, circles, options);
    const Linearised set = linearise(*model.measurement, fit, model.options, {});
    std::vector<double> share(set.visits);
    std::vector<int> taking(set.visits);
    for (const LinearReading& reading : set.readings) {
      share[reading.visit] += reading.along * reading.residual;
      taking[reading.visit] += reading.takesPart ? 1 : 0;
    }
    for (const LinearReading& reading : set.readings) {
      const bool counts = reading.visit % 5 == fold && reading.takesPart && taking[reading.visit] > 1;
      if (!counts || reading.kind == ReadingKind::Slider) continue;
      const double left = reading.residual - share[reading.visit] * reading.along;
      sum += std::pow(left * Angle::fromRadians(reading.sigma).arcseconds(), 2);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

// The equations are linearised at the fit of all readings. The new fits differ by a few arcseconds, where
// curvature is below a millionth.
TEST(HeldOut, IsWhatNewFitsWithoutTheReadingsSay) {
  Truth truth = drawTruth(3);
  truth.effects = {{ErrorTerm::TrunnionTilt, 25}, {ErrorTerm::EllipticityCosine, 0.1}};
  for (const char* protocol : {"paper", "full"}) {
    SCOPED_TRACE(protocol);
    const GapModel before = *modelOf(read(protocol, truth));
    const GapModel after = with(before, {ErrorTerm::EllipticityCosine, ErrorTerm::EllipticitySine}, 0.05);
    EXPECT_NEAR(heldOutShrinkage(before, after), 1 - rmsOfRefits(after) / rmsOfRefits(before), 1e-4);
    GapModel blamed = with(before, {ErrorTerm::TrunnionTilt}, 1e-4);
    blamed.options.without = {{0, 4, ReadingKind::Vertical}, {1, 7, ReadingKind::Horizontal}};
    blamed.refit();
    EXPECT_NEAR(heldOutShrinkage(before, blamed), 1 - rmsOfRefits(blamed) / rmsOfRefits(before), 1e-4);
  }
}

// Meaningless numbers always fit slightly better and predict slightly worse. Two numbers for 68 readings: the
// results of single sessions scatter by some percent, the mean of 30 by less than one.
TEST(HeldOut, PunishesNumbersThatMeanNothing) {
  double inSample = 0, heldOut = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const GapModel before = *modelOf(read("paper", drawTruth(seed), seed));
    const GapModel after = with(before, {ErrorTerm::EllipticityCosine, ErrorTerm::EllipticitySine}, 1);
    EXPECT_LT(after.fit->chiSquare, before.fit->chiSquare);
    inSample += before.fit->chiSquare - after.fit->chiSquare;
    heldOut += heldOutShrinkage(before, after) / 30;
  }
  EXPECT_NEAR(inSample / 30, 2, 1);  // χ² of two numbers, ± 2/√30
  EXPECT_LT(heldOut, 0);
  EXPECT_GT(heldOut, -0.2);
}

// With one face and without slider the sighting is alone in its visit, so it cannot be predicted. Without it
// only noise remains, with it the gross error plus noise. Both figures include its effect on the 17 + 17
// visits.
TEST(HeldOut, DoesWithoutASightingThatIsMisread) {
  for (const double size : {60.0, 400.0, 900.0}) {
    SCOPED_TRACE(size);
    Truth truth = drawTruth(3);
    truth.grossErrors = {
        {.axisDeg = 0, .point = 5, .horizontal = {}, .vertical = Angle::fromArcseconds(size)}};
    const Diagnosis diagnosis = *diagnose(read("paper", truth));
    ASSERT_EQ(diagnosis.causes.size(), 1u);
    EXPECT_EQ(diagnosis.causes[0].effect, "gross_error");
    EXPECT_GT(diagnosis.shrink.inSample, 0.7);
    EXPECT_NEAR(diagnosis.shrink.heldOut, diagnosis.shrink.inSample, 0.1);
  }
}

TEST(HeldOut, IsNoNumberWhereTooFewPlacesAreLeft) {
  Protocol protocol = *protocolByName("paper");
  protocol.points = 3;
  protocol.step = Angle::fromDegrees(60);
  protocol.axes = {0};
  const GapModel model = *modelOf(test::measurementOf(*simulate(protocol, drawTruth(3), 3)));
  GapModel after = model;
  after.options.terms = {{ErrorTerm::Collimation, 1e-4}};
  EXPECT_TRUE(std::isnan(heldOutShrinkage(model, after)));
}

}  // namespace
}  // namespace alidade
