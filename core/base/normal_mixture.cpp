#include "core/base/normal_mixture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/statistics.h"

namespace alidade {

namespace {

double sharesOf(const std::vector<NormalPart>& mixture) {
  double sum = 0;
  for (const NormalPart& part : mixture) sum += part.share;
  return sum;
}

/// Φ(high) − Φ(low).
double between(double low, double high) {
  return (std::erf(high / std::sqrt(2)) - std::erf(low / std::sqrt(2))) / 2;
}

double shareWithin(const std::vector<NormalPart>& mixture, double centre, double half) {
  double sum = 0;
  for (const NormalPart& part : mixture) {
    const double off = centre - part.mean;
    sum += part.share * between((off - half) / part.sigma, (off + half) / part.sigma);
  }
  return sum;
}

}  // namespace

MeanAndSigma momentsOf(const std::vector<NormalPart>& mixture) {
  assert(!mixture.empty());
  const double all = sharesOf(mixture);
  double mean = 0, variance = 0;
  for (const NormalPart& part : mixture) mean += part.share * part.mean / all;
  for (const NormalPart& part : mixture)
    variance += part.share * (part.sigma * part.sigma + std::pow(part.mean - mean, 2)) / all;
  return {mean, std::sqrt(variance)};
}

double halfWidth(const std::vector<NormalPart>& mixture, double centre, double coverage) {
  assert(!mixture.empty() && coverage > 0 && coverage < 1);
  const double wanted = coverage * sharesOf(mixture), factor = normalQuantile((1 + coverage) / 2);
  // `high` starts as the largest half-width of a single part. It is an upper limit, since within it every
  // part has at least the coverage.
  double low = 0, high = 0;
  for (const NormalPart& part : mixture)
    high = std::max(high, std::abs(part.mean - centre) + factor * part.sigma);
  while (high - low > 1e-6 * high) {
    const double middle = (low + high) / 2;
    (shareWithin(mixture, centre, middle) < wanted ? low : high) = middle;
  }
  return high;
}

std::vector<NormalPart> joined(const std::vector<NormalPart>& mixture, double grain) {
  using Cell = std::pair<double, double>;
  std::map<Cell, std::vector<NormalPart>> cells;
  for (const NormalPart& part : mixture)
    cells[{std::floor(part.mean / grain), std::floor(part.sigma / grain)}].push_back(part);
  std::vector<NormalPart> parts;
  for (const auto& [cell, alike] : cells) {
    const MeanAndSigma moments = momentsOf(alike);
    parts.push_back({sharesOf(alike), moments.mean, moments.sigma});
  }
  return parts;
}

}  // namespace alidade
