#include "core/adjustment/result/reading_step.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace alidade {

namespace {

// arcsec, the coarsest first
constexpr double usualSteps[] = {3600, 3240, 1800, 1620, 648,  600, 360, 324, 300, 162, 120, 64.8, 60,  36,
                                 32.4, 30,   20,   18,   16.2, 15,  12,  10,  7.2, 6,   5,   3.6,  3.24};

}  // namespace

std::optional<Angle> readingStep(const std::vector<Angle>& readings, Angle finest) {
  constexpr std::size_t fewest = 6;
  constexpr double rounding = 1e-5;  // arcsec
  std::vector<double> differences;
  for (const Angle& reading : readings)
    differences.push_back(wrapped(reading - readings.front()).arcseconds());
  const auto divides = [&](double step) {
    return std::ranges::all_of(differences, [&](double difference) {
      return std::abs(difference - step * std::round(difference / step)) < rounding;
    });
  };
  const double* const step = std::ranges::find_if(usualSteps, divides);
  if (step == std::end(usualSteps) || *step <= finest.arcseconds()) return std::nullopt;
  std::ranges::sort(differences);
  const auto end = std::unique(differences.begin(), differences.end(),
                               [](double a, double b) { return b - a < rounding; });
  if (static_cast<std::size_t>(end - differences.begin()) < fewest) return std::nullopt;
  return Angle::fromArcseconds(*step);
}

Angle roundingSigma(Angle step) {
  return step * (1 / std::sqrt(12.0));
}

}  // namespace alidade
