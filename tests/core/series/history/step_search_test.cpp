#include "core/series/history/step_search.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

namespace alidade {
namespace {

/// χ² of values about the mean of each stretch, from the definition.
double chiSquareOf(const std::vector<double>& x, const std::vector<double>& u,
                   const std::vector<std::size_t>& firsts) {
  double sum = 0;
  for (std::size_t i = 0; i <= firsts.size(); ++i) {
    const std::size_t begin = i == 0 ? 0 : firsts[i - 1], end = i == firsts.size() ? x.size() : firsts[i];
    double w = 0, wx = 0;
    for (std::size_t j = begin; j < end; ++j) {
      w += 1 / (u[j] * u[j]);
      wx += x[j] / (u[j] * u[j]);
    }
    for (std::size_t j = begin; j < end; ++j) sum += std::pow((x[j] - wx / w) / u[j], 2);
  }
  return sum;
}

/// Returns χ² of the best of all ways to place this many steps.
double bruteForce(const std::vector<double>& x, const std::vector<double>& u, std::size_t steps) {
  double best = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> firsts;
  const std::function<void(std::size_t)> place = [&](std::size_t from) {
    if (firsts.size() == steps) {
      best = std::min(best, chiSquareOf(x, u, firsts));
      return;
    }
    for (std::size_t first = from; first < x.size(); ++first) {
      firsts.push_back(first);
      place(first + 1);
      firsts.pop_back();
    }
  };
  place(1);
  return best;
}

TEST(StepSearch, FindsTheBestOfAllPlacesOfAnyNumberOfSteps) {
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  for (int draw = 0; draw < 20; ++draw) {
    std::vector<double> x, u;
    std::vector<WeightedSums> sums;
    for (int i = 0; i < 9; ++i) {
      u.push_back(0.5 + std::abs(normal(generator)));
      x.push_back(normal(generator) * 2 + (i > 4 ? 3 : 0));
      const double w = 1 / (u.back() * u.back());
      sums.push_back({w, w * x.back(), w * x.back() * x.back()});
    }
    const DateSums dates(sums);
    StepSearch search(dates);
    for (std::size_t steps = 1; steps <= 8; ++steps) {
      const Stepping found = search.next();
      EXPECT_EQ(found.firsts.size(), steps);
      EXPECT_NEAR(found.chiSquare, bruteForce(x, u, steps), 1e-9) << steps;
      EXPECT_NEAR(found.chiSquare, chiSquareOf(x, u, found.firsts), 1e-9) << steps;
    }
  }
}

}  // namespace
}  // namespace alidade
