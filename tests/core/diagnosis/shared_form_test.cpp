#include "core/diagnosis/shared_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace alidade {
namespace {

FoundForm dent(FormNumber at, FormNumber depth) {
  FoundForm found;
  found.form = {.function = FormFunction::Bump, .of = FormArgument::S};
  found.coefficients = {{"A", depth.value, depth.sigma}};
  found.parameters = {{"at_deg", at.value, at.sigma}, {"width_deg", 8, 1}, depth};
  return found;
}

FormNumber at(double value, double sigma) {
  return {"at_deg", value, sigma};
}

FormNumber deep(double value, double sigma) {
  return {"amplitude_mm", value, sigma};
}

// 3 u of a difference are 3 √(0.3² + 0.4²) = 1.5.
TEST(SharedForm, AgreesWithinThreeU) {
  const FoundForm one = dent(at(70, 0.3), deep(0.1, 0.01));
  EXPECT_TRUE(agrees(one, dent(at(71.4, 0.4), deep(0.3, 0.01))));
  EXPECT_FALSE(agrees(one, dent(at(71.6, 0.4), deep(0.1, 0.01))));
}

TEST(SharedForm, AgreesWithNoneWhoseShapeIsUnsettled) {
  const FoundForm one = dent(at(70, 0.3), deep(0.1, 0.01));
  for (const double u : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(agrees(one, dent(at(70, u), deep(0.1, 0.01))));
    EXPECT_FALSE(agrees(dent(at(70, u), deep(0.1, 0.01)), one));
  }
}

// Calculated by hand. The weights are 1 and 1/4. The depths differ by 4 u: χ² = 8 with one degree of freedom.
TEST(SharedForm, IsTheMeanByWeightWithBirgesRatio) {
  const FoundForm first = dent(at(70, 1), deep(0.1, 0.01)), second = dent(at(71, 2), deep(0.14, 0.01));
  const FoundForm mean = meanOf({&first, &second});
  EXPECT_NEAR(mean.parameters[0].value, 70.2, 1e-12);
  EXPECT_NEAR(mean.parameters[0].sigma, std::sqrt(0.8), 1e-12);
  EXPECT_NEAR(mean.parameters[2].value, 0.12, 1e-12);
  EXPECT_NEAR(mean.parameters[2].sigma, std::sqrt(8) * 0.01 / std::sqrt(2), 1e-12);
  EXPECT_EQ(mean.formula, "radial = A*bump(s, 70.2°, 8.0°)");
}

// The u of an order may be far below rounding: a weighted mean of orders would not be a whole number.
TEST(SharedForm, KeepsTheOrder) {
  std::vector<FoundForm> waves;
  for (const double u : {3e-41, 7e-39, 2e-40}) {
    FoundForm& wave = waves.emplace_back();
    wave.form = {.of = FormArgument::S, .order = 7};
    wave.coefficients = {{"A", 0.15, 0.004}, {"B", 0.1, 0.004}};
    wave.parameters = {{"order", 7, u}, deep(0.18, 0.004)};
  }
  EXPECT_EQ(meanOf({&waves[0], &waves[1], &waves[2]}).parameters[0].value, 7);
}

}  // namespace
}  // namespace alidade
