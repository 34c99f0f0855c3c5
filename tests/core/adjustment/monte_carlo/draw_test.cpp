#include "core/adjustment/monte_carlo/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

constexpr double known = std::numeric_limits<double>::infinity();

/// Nine sightings at 0°, every other with the slider, and six at 180° without.
Measurement unlikeArcs() {
  Measurement measurement = test::usualMeasurement();
  measurement.arcs = {test::perfectArc(measurement, {0, 1, 400}, test::spread(9, 160), 0),
                      test::perfectArc(measurement, {0, -1, 400}, test::spread(6, 120, -90), 180)};
  for (Sighting& sighting : measurement.arcs[0].sightings)
    if (sighting.point % 2 == 0) sighting.slider = Angle::fromDegrees(20 * sighting.point);
  return measurement;
}

/// The largest distance of the sample from a distribution (Kolmogorov), in 1/√n: above 2.23 once in 10⁴
/// times.
double distanceFrom(const std::function<double(double)>& distribution, std::vector<double> drawn) {
  std::ranges::sort(drawn);
  const auto n = static_cast<double>(drawn.size());
  double greatest = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const double below = distribution(drawn[i]), rank = static_cast<double>(i);
    greatest = std::max({greatest, below - rank / n, (rank + 1) / n - below});
  }
  return greatest * std::sqrt(n);
}

constexpr double hardlyEver = 2.23;

double normalDistribution(double x) {
  return std::erfc(-x / std::numbers::sqrt2) / 2;
}

// Each number has one index: none is unused, none is used twice.
TEST(Draw, GivesEveryUncertainNumberAPlaceOfItsOwn) {
  for (const std::vector<std::string>& effects :
       {std::vector<std::string>{}, {"collimation"}, {"plane_tilt", "vertical_drift"}}) {
    Measurement measurement = unlikeArcs();
    measurement.effects = effects;
    const DrawPlan plan(measurement, {1, 5});
    EXPECT_EQ(plan.terms(), effects.empty() ? 0 : 2 * effects.size() - 1) << "a tilt is two numbers";
    Draw draw;
    plan.drawInto(draw, 1, 1);
    std::vector<int> uses(draw.normals.size());
    const auto use = [&](std::size_t first, std::size_t count) {
      for (std::size_t i = first; i < first + count; ++i) ++uses.at(i);
    };
    use(DrawPlan::distance, 1);
    use(DrawPlan::radius, 1);
    use(DrawPlan::firstTerm, plan.terms());
    for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc) {
      use(plan.zeros(arc), 2);
      for (std::size_t i = 0; i < measurement.arcs[arc].sightings.size(); ++i)
        use(plan.readings(arc, i), measurement.arcs[arc].sightings[i].slider ? 3 : 2);
    }
    EXPECT_EQ(uses, std::vector<int>(uses.size(), 1));
  }
}

// The draws are made in reverse order, into a draw of a longer plan, and by a new plan.
TEST(Draw, IsTheSameWhoeverAsksForIt) {
  const Measurement measurement = unlikeArcs();
  const NoiseScale noise{1.3, 12};
  const DrawPlan plan(measurement, noise), again(measurement, noise);
  std::vector<Draw> drawn(20);
  for (std::size_t i = 0; i < drawn.size(); ++i) plan.drawInto(drawn[i], 7, i);
  Draw used;
  used.normals.assign(1000, 5);
  for (std::size_t i = drawn.size(); i-- > 0;) {
    again.drawInto(used, 7, i);
    EXPECT_EQ(used.scale, drawn[i].scale) << i;
    EXPECT_EQ(used.normals, drawn[i].normals) << i;
    again.drawInto(used, 8, i);
    EXPECT_NE(used.normals, drawn[i].normals) << "of another seed";
    EXPECT_NE(used.normals, drawn[(i + 1) % drawn.size()].normals) << "of another seed and number";
    EXPECT_NE(drawn[i].normals, drawn[(i + 1) % drawn.size()].normals) << "of another number";
  }
}

// 500 draws of 46 numbers; neighbours in one draw, and the same number in two draws, are independent: the
// mean of n products is 0 within 1/√n, here four times that.
TEST(Draw, IsOfIndependentNormalNumbers) {
  const DrawPlan plan(unlikeArcs(), {1, known});
  Draw draw, before;
  std::vector<double> all;
  double neighbours = 0, draws = 0;
  plan.drawInto(before, 3, 0);
  for (std::uint64_t number = 1; number <= 500; ++number) {
    plan.drawInto(draw, 3, number);
    for (std::size_t i = 1; i < draw.normals.size(); ++i) {
      neighbours += draw.normals[i] * draw.normals[i - 1];
      draws += draw.normals[i] * before.normals[i];
      all.push_back(draw.normals[i]);
    }
    std::swap(draw, before);
  }
  const auto n = static_cast<double>(all.size());
  EXPECT_LT(std::abs(neighbours), 4 * std::sqrt(n));
  EXPECT_LT(std::abs(draws), 4 * std::sqrt(n));
  EXPECT_LT(distanceFrom(normalDistribution, all), hardlyEver);
}

// A reading's error divided by s0 is Student's, whose distributions with 1, 2 and 4 degrees of freedom have
// closed forms. With many it is almost normal, and exactly so if the noise is known. Large and small s0 in
// turn.
TEST(Draw, ScattersReadingsAsStudentDid) {
  struct Case {
    double factor, freedom;
    std::function<double(double)> distribution;
  };
  const auto ofTwo = [](double t) { return 0.5 + t / (2 * std::sqrt(2 + t * t)); };
  const auto ofFour = [](double t) {
    const double share = t * t / (1 + t * t / 4);
    return 0.5 + 0.375 * t / std::sqrt(1 + t * t / 4) * (1 - share / 12);
  };
  for (const Case& one : {Case{0.4, 1, [](double t) { return 0.5 + std::atan(t) / std::numbers::pi; }},
                          {7, 2, ofTwo},
                          {1, 4, ofFour},
                          {3, 1e6, normalDistribution},
                          {0.5, known, normalDistribution}}) {
    const DrawPlan plan(unlikeArcs(), {one.factor, one.freedom});
    std::vector<double> errors;
    Draw draw;
    for (std::uint64_t number = 0; number < 20000; ++number) {
      plan.drawInto(draw, 11, number);
      errors.push_back(draw.scale / one.factor * draw.normals[plan.readings(1, 5)]);
      EXPECT_EQ(draw.scale == one.factor, one.freedom == known);
    }
    EXPECT_LT(distanceFrom(one.distribution, errors), hardlyEver) << one.freedom;
  }
}

// (s0/scale)² is χ² divided by its degrees of freedom f, integer or fractional: its mean is 1 and its
// variance 2/f. For n draws the mean is known to √(2/(f n)), with four times that allowed; the variance to 2
// % even at f = 1. With 1, 2 and 4 degrees of freedom the distribution has a closed form. A plan without
// readings is drawn fast.
TEST(Draw, HasTheScaleOfAnyDegreesOfFreedom) {
  constexpr std::uint64_t draws = 100000;
  struct Case {
    double freedom;
    std::function<double(double)> distribution;
  };
  for (const Case& one : {Case{1, [](double x) { return std::erf(std::sqrt(x / 2)); }},
                          {1.5, {}},
                          {1.99, {}},
                          {2, [](double x) { return 1 - std::exp(-x / 2); }},
                          {4, [](double x) { return 1 - std::exp(-x / 2) * (1 + x / 2); }},
                          {51, {}}}) {
    SCOPED_TRACE(one.freedom);
    const DrawPlan plan(Measurement(), {2.5, one.freedom});
    std::vector<double> squares;
    double sum = 0, ofSquares = 0;
    Draw draw;
    for (std::uint64_t number = 0; number < draws; ++number) {
      plan.drawInto(draw, 5, number);
      const double share = std::pow(2.5 / draw.scale, 2);
      squares.push_back(share * one.freedom);
      sum += share;
      ofSquares += share * share;
    }
    const double mean = sum / draws;
    EXPECT_NEAR(mean, 1, 4 * std::sqrt(2 / one.freedom / draws));
    EXPECT_NEAR(ofSquares / draws - mean * mean, 2 / one.freedom, 0.06 * 2 / one.freedom);
    if (one.distribution) {
      EXPECT_LT(distanceFrom(one.distribution, squares), hardlyEver);
    }
  }
}

}  // namespace
}  // namespace alidade
