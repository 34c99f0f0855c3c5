#include "core/diagnosis/discover.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "core/base/random_source.h"

namespace alidade {
namespace {

using ::testing::HasSubstr;

constexpr double perDegree = std::numbers::pi / 180;

/// A pointing of a mount; angles in degrees, `time` 0…1.
struct Target {
  bool isHorizontal;
  double azimuth, elevation, time;
};

/// 100 pointings with 3″ of noise, and a model of five terms that a fit has absorbed.
std::string tableWith(std::uint64_t seed, const std::function<double(const Target&)>& form) {
  RandomSource random(seed);
  std::string text =
      "circle,azimuth_deg,elevation_deg,time,residual_arcsec,sigma_arcsec,base:IA,base:IE,base:AN\n";
  constexpr int pointings = 100;
  for (int i = 0; i < pointings; ++i) {
    const double azimuth = random.uniform(0, 360), elevation = random.uniform(15, 85);
    for (const bool isHorizontal : {true, false}) {
      const double time = static_cast<double>(i) / (pointings - 1);
      const double tilt = isHorizontal ? std::sin(azimuth * perDegree) * std::tan(elevation * perDegree)
                                       : std::cos(azimuth * perDegree);
      const double residual = 3 * random.normal() + form({isHorizontal, azimuth, elevation, time}) + 4 * tilt;
      text += std::string(isHorizontal ? "horizontal" : "vertical") + "," + std::to_string(azimuth) + "," +
              std::to_string(elevation) + "," + std::to_string(i) + "," + std::to_string(residual) + ",3," +
              (isHorizontal ? "1,0," : "0,1,") + std::to_string(tilt) + "\n";
    }
  }
  return text;
}

double numberOf(const FoundForm& found, const std::string& name) {
  return std::ranges::find(found.parameters, name, &FormNumber::name)->value;
}

TEST(Discover, FindsAHarmonicOfTheAzimuth) {
  const Discovery found = *discover(tableWith(1, [](const Target& target) {
    return target.isHorizontal ? 9 * std::cos(3 * target.azimuth * perDegree) : 0;
  }));
  ASSERT_EQ(found.forms.size(), 1U);
  const FoundForm& form = found.forms.front();
  EXPECT_EQ(form.form.carrier, FormCarrier::Horizontal);
  EXPECT_EQ(form.form.of, FormArgument::Azimuth);
  EXPECT_EQ(form.form.order, 3);
  EXPECT_NEAR(numberOf(form, "amplitude_arcsec"), 9, 1.5);
  EXPECT_EQ(form.shrink.heldOutReadings, 200);
  EXPECT_LT(form.shrink.p, 1e-6);
  EXPECT_NEAR(found.noise, 1, 0.15);
}

TEST(Discover, FindsABumpAndASettling) {
  const Discovery bump = *discover(tableWith(2, [](const Target& target) {
    return target.isHorizontal ? 0 : 20 * std::exp(-0.5 * std::pow((target.elevation - 50) / 7, 2));
  }));
  ASSERT_FALSE(bump.forms.empty());
  EXPECT_EQ(bump.forms.front().form.function, FormFunction::Bump);
  EXPECT_NEAR(numberOf(bump.forms.front(), "at_deg"), 50, 2);
  EXPECT_NEAR(numberOf(bump.forms.front(), "width_deg"), 7, 2);
  const Discovery settling = *discover(tableWith(3, [](const Target& target) {
    return (target.isHorizontal ? 30 : -20) * std::exp(-target.time / 0.15);
  }));
  ASSERT_FALSE(settling.forms.empty());
  EXPECT_EQ(settling.forms.front().form.carrier, FormCarrier::Orientation);
  EXPECT_EQ(settling.forms.front().form.function, FormFunction::Exponential);
  EXPECT_NEAR(numberOf(settling.forms.front(), "tau"), 0.15, 0.05);
  EXPECT_NEAR(numberOf(settling.forms.front(), "vertical_arcsec"), -20, 5);
}

TEST(Discover, FindsNothingInNoise) {
  int named = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
    named += discover(tableWith(seed, [](const Target&) { return 0.0; }))->forms.empty() ? 0 : 1;
  EXPECT_LE(named, 1);
}

std::string problemOf(const std::string& text) {
  const Result<Discovery> found = discover(text);
  return found ? "" : found.problem().text();
}

TEST(Discover, SaysWhatIsWrongAndWhere) {
  const std::string head = "residual_arcsec,sigma_arcsec,circle,azimuth_deg,elevation_deg\n";
  EXPECT_THAT(problemOf(""), HasSubstr("at least 12"));
  EXPECT_THAT(problemOf("a,b\n1,2\n"), HasSubstr("there is no column residual_arcsec"));
  EXPECT_THAT(problemOf(head + "1,2,horizontal,10,20\n"), HasSubstr("1 rows"));
  EXPECT_THAT(problemOf(head + "1,2,sideways,10,20\n"),
              HasSubstr("Line 2: the circle “sideways” is unknown"));
  EXPECT_THAT(problemOf(head + "\n1,x,vertical,10,20\n"), HasSubstr("Line 3: sigma_arcsec is “x”"));
  EXPECT_THAT(problemOf(head + "1,0,vertical,10,20\n"), HasSubstr("Line 2: sigma_arcsec is 0"));
  EXPECT_THAT(problemOf(head + "1,2,vertical,10,95\n"), HasSubstr("elevation_deg is 95"));
  EXPECT_THAT(problemOf(head + "1,2,vertical,10\n"), HasSubstr("elevation_deg is “”"));
  EXPECT_THAT(problemOf("circle," + head), HasSubstr("occurs twice"));
  std::string bases = "residual_arcsec,sigma_arcsec,circle,azimuth_deg,elevation_deg";
  std::string rows;
  for (int b = 0; b < 12; ++b) bases += ",base:b" + std::to_string(b);
  for (int i = 0; i < 12; ++i) {
    rows += "\n1,2,vertical," + std::to_string(i) + ",20";
    for (int b = 0; b < 12; ++b) rows += b == i ? ",1" : ",0";
  }
  EXPECT_THAT(problemOf(bases + rows + "\n"), HasSubstr("no degree of freedom in the 12 residuals"));
}

}  // namespace
}  // namespace alidade
