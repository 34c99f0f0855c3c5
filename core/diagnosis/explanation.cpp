#include "core/diagnosis/explanation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/diagnosis/gain.h"
#include "core/diagnosis/search.h"

namespace alidade {

using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// ln ∫ p(scale) (evidence at the scale/evidence at `reference`) over ln scale in [from, to], with
/// `logDensity` of ln scale: −f ln scale − ½ χ²/scale².
template <typename Density>
double logOverScales(double chiSquare, double f, double reference, double from, double to,
                     const Density& logDensity, double& likeliest) {
  constexpr int steps = 60;
  const double step = (to - from) / steps, logReference = std::log(reference);
  std::array<double, steps + 1> values;
  int best = 0;
  for (int i = 0; i <= steps; ++i) {
    const double log = from + step * i;
    values[static_cast<std::size_t>(i)] =
        logDensity(log) - f * (log - logReference) -
        0.5 * chiSquare * (std::exp(-2 * log) - 1 / (reference * reference));
    if (values[static_cast<std::size_t>(i)] > values[static_cast<std::size_t>(best)]) best = i;
  }
  likeliest = std::exp(from + step * best);
  const double highest = values[static_cast<std::size_t>(best)];
  double sum = 0;
  for (const double value : values) sum += std::exp(value - highest);
  return highest + std::log(sum * step);
}

constexpr double knownTo = 0.1;  // the stated σ holds to a tenth
constexpr double leastNoise = 1.25, mostNoise = 20;

void add(Explanation& set, double logEvidence) {
  set.logEvidence += logEvidence;
  set.logOdds += logEvidence;
}

void weighNominal(Explanation& found, double f) {
  const auto density = [](double log) {
    return -0.5 * std::pow(log / knownTo, 2) - std::log(knownTo) - 0.5 * std::log(2 * M_PI);
  };
  add(found, logOverScales(found.chiSquare, f, 1, -4 * knownTo, 4 * knownTo, density, found.noise));
}

void weighNoisy(Explanation& found, double f, double reference, double leftover) {
  const double from = std::log(leastNoise), to = std::log(mostNoise);
  const auto density = [&](double) { return -std::log(to - from); };
  found.noisy = true;
  add(found, logOverScales(found.chiSquare, f, reference, from, to, density, found.noise));
  add(found, -f * std::log(reference) - 0.5 * leftover * (1 / (reference * reference) - 1));
}

}  // namespace

namespace {

/// The likeliest set without a pattern.
const Explanation& bestNamed(const std::vector<Explanation>& sets) {
  const Explanation* best = &sets.front();
  for (const Explanation& set : sets)
    if (!set.shaped && set.logOdds > best->logOdds) best = &set;
  return *best;
}

void normalise(std::vector<Explanation>& sets) {
  const double base = sets.front().logEvidence;  // nothing at all, noise as stated
  double sum = impossible;
  for (Explanation& set : sets) {
    set.logOdds -= base;
    set.logEvidence -= base;
    sum = logSum(sum, set.logOdds);
  }
  for (Explanation& set : sets) set.chance = std::exp(set.logOdds - sum);
  std::ranges::sort(sets, std::greater{}, &Explanation::logOdds);
}

}  // namespace

std::vector<Explanation> explain(const Leftover& leftover, const std::vector<Component>& candidates,
                                 const SearchOptions& options) {
  const double f = leftover.degreesOfFreedom(), chiSquare = leftover.chiSquare();
  Search search(leftover, candidates, options);
  std::vector<Explanation> all = search.grown(1);
  for (Explanation& set : all) weighNominal(set, f);
  std::vector<double> references;
  for (const double left : {chiSquare, bestNamed(all).chiSquare}) {
    const double reference = std::clamp(std::sqrt(left / std::max(f, 1.0)), leastNoise, mostNoise);
    if (references.empty() || reference < 0.8 * references.back()) references.push_back(reference);
  }
  if (!options.noise) references.clear();
  for (const double reference : references)
    for (Explanation& set : search.grown(reference * reference)) {
      set.logOdds += std::log(options.odds.noise);
      weighNoisy(set, f, reference, chiSquare);
      all.push_back(std::move(set));
    }
  normalise(all);
  return all;
}

namespace {

BentFit fitBentAlone(const Leftover& leftover, const Component& component) {
  const MatrixXd columns = bentColumns(component);
  return fitBent(widthsOf(component.kind), columns.transpose() * columns,
                 columns.transpose() * leftover.residual(), 1);
}

}  // namespace

double logBayesFactor(const Leftover& leftover, const Component& component) {
  if (component.curvature.cols() > 0) return fitBentAlone(leftover, component).gain.log;
  const VectorXd right = component.columns.transpose() * leftover.residual();
  if (component.allOrNothing) return right[0] - component.gram(0, 0) / 2;
  return gainOf(widthsOf(component.kind), component.gram, right, 1).log;
}

VectorXd likelyWeights(const Leftover& leftover, const Component& component) {
  if (component.curvature.cols() > 0) return fitBentAlone(leftover, component).weights;
  if (component.allOrNothing) return VectorXd::Ones(1);
  const VectorXd right = component.columns.transpose() * leftover.residual();
  const double width = gainOf(widthsOf(component.kind), component.gram, right, 1).width;
  MatrixXd matrix = component.gram;
  matrix.diagonal().array() += 1 / (width * width);
  return matrix.ldlt().solve(right);
}

}  // namespace alidade
