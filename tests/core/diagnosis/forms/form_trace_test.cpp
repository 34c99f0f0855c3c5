#include "core/diagnosis/forms/find_forms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/diagnosis/diagnose.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

constexpr double depth = -0.5, place = 70, width = 11;  // mm, degrees

FoundForm traced(const Truth& truth, std::uint64_t seed) {
  const Diagnosis diagnosis =
      *diagnose(*examine(*simulate(*protocolByName("full"), truth, seed)).measurement);
  return diagnosis.forms.empty() ? FoundForm() : diagnosis.forms.front();
}

FoundForm dent() {
  Truth truth = drawTruth(5);
  truth.foreign = ForeignEffect{ForeignEffect::Kind::LocalDent, depth, place, width};
  return traced(truth, 5);
}

double truthAt(double s) {
  return depth * std::exp(-0.5 * std::pow((s - place) / width, 2));
}

// Compares with the simulated truth, which the fit does not know. σ of both circles is 2″ at 2.4 m.
TEST(FormTrace, EachSightingSaysWhatTheDentIsThere) {
  const FoundForm found = dent();
  constexpr std::size_t rows = 136;
  ASSERT_EQ(found.trace.points.size(), rows);
  constexpr double sigma = 2.0 / 206265 * 2438;  // mm, at the distance of the arc
  EXPECT_NEAR(found.trace.sigma, sigma, 0.05 * sigma);
  double before = 0, after = 0, heldOut = 0;
  for (const FormPoint& point : found.trace.points) {
    before += std::pow(point.before - truthAt(point.at), 2);
    after += point.after * point.after;
    heldOut += point.heldOut * point.heldOut;
  }
  // The 136 rows scatter by the noise, minus the part absorbed by the fit, plus the error of the fit.
  EXPECT_NEAR(std::sqrt(before / rows), sigma, 0.3 * sigma);
  EXPECT_NEAR(std::sqrt(after / rows), sigma, 0.2 * sigma);
  EXPECT_GT(heldOut, after) << "predicted is never as good as fitted";
  EXPECT_LT(heldOut, 2 * after);
}

TEST(FormTrace, TheCurveIsTheDent) {
  const FoundForm found = dent();
  ASSERT_GT(found.trace.curve.size(), 100U);
  const double u = found.coefficients.front().sigma;
  for (const auto& [s, value, same] : found.trace.curve) EXPECT_NEAR(value, truthAt(s), 3 * u) << s;
  EXPECT_NEAR(found.trace.curve.front()[0], 10, 0.2);
  EXPECT_NEAR(found.trace.curve.back()[0], 170, 0.2);
}

// z follows from |depth| exp(−½ z²) = σ. Place and width of the dent are known to a few tenths of a degree.
TEST(FormTrace, TheModelHoldsBesideTheDent) {
  const FoundForm found = dent();
  const double reach = width * std::sqrt(2 * std::log(std::abs(depth) / found.trace.sigma));
  ASSERT_EQ(found.cleanRange.size(), 2U);
  EXPECT_NEAR(found.cleanRange[0][1], place - reach, 3);
  EXPECT_NEAR(found.cleanRange[1][0], place + reach, 3);
  EXPECT_NEAR(found.cleanRange[1][1], 170, 0.5);
}

TEST(FormTrace, AHarmonicGoesOnEverywhere) {
  Truth truth = drawTruth(11);
  truth.harmonic = FormHarmonic{.order = 7, .cosine = 0.2, .sine = 0.15};
  const FoundForm found = traced(truth, 11);
  ASSERT_EQ(found.form.function, FormFunction::Harmonic);
  EXPECT_TRUE(found.cleanRange.empty());
  EXPECT_EQ(found.trace.points.size(), 136U);
}

}  // namespace
}  // namespace alidade
