#include "core/diagnosis/search/explanation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/diagnosis/evidence/bent_fit.h"
#include "core/diagnosis/result/noise_policy.h"
#include "core/diagnosis/search/search.h"

namespace alidade {

using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

using noise_policy::knownTo;
constexpr double outOfQuestion = 1e-4;  // odds below which the search ignores larger noise

/// Prior of the noise scale: density at equal steps of its logarithm.
class NoiseScales {
 public:
  template <typename Density>
  NoiseScales(double from, double to, const Density& logDensity)
      : m_step((to - from) / steps), m_logs(Logs::LinSpaced(steps + 1, from, to)) {
    m_densities = m_logs.unaryExpr(logDensity);
    m_inverseSquares = (-2 * m_logs).exp();
  }

  /// Returns ln ∫ p(s) E(s)/E(`reference`) d ln s over the noise scale s. p is the prior density of ln s,
  /// and ln E(s) = −f ln s − ½ χ²/s².
  double logIntegral(double chiSquare, double f, double reference, double& likeliest) const {
    const Logs values = m_densities - f * (m_logs - std::log(reference)) -
                        0.5 * chiSquare * (m_inverseSquares - 1 / (reference * reference));
    Eigen::Index best = 0;
    const double highest = values.maxCoeff(&best);
    likeliest = std::exp(m_logs[best]);
    return highest + std::log((values - highest).exp().sum() * m_step);
  }

 private:
  static constexpr int steps = 60;
  using Logs = Eigen::Array<double, steps + 1, 1>;
  double m_step;
  Logs m_logs, m_densities, m_inverseSquares;
};

void add(Explanation& set, double logBayesFactor) {
  set.logBayesFactor += logBayesFactor;
  set.logPosteriorOdds += logBayesFactor;
}

const NoiseScales& nominalScales() {
  static const NoiseScales scales(-4 * knownTo, 4 * knownTo, [](double log) {
    return -0.5 * std::pow(log / knownTo, 2) - std::log(knownTo) - 0.5 * std::log(2 * M_PI);
  });
  return scales;
}

const NoiseScales& largerScales() {
  static const double from = std::log(noise_policy::least), to = std::log(noise_policy::most);
  static const NoiseScales scales(from, to, [](double) { return -std::log(to - from); });
  return scales;
}

void weighNominal(Explanation& found, double f) {
  add(found, nominalScales().logIntegral(found.chiSquare, f, 1, found.noise));
}

void weighNoisy(Explanation& found, double f, double reference, double leftover) {
  found.noisy = true;
  add(found, largerScales().logIntegral(found.chiSquare, f, reference, found.noise));
  add(found, -f * std::log(reference) - 0.5 * leftover * (1 / (reference * reference) - 1));
}

/// Returns the most likely set without a pattern.
const Explanation& bestNamed(const std::vector<Explanation>& sets) {
  const Explanation* best = &sets.front();
  for (const Explanation& set : sets)
    if (!set.shaped && set.logPosteriorOdds > best->logPosteriorOdds) best = &set;
  return *best;
}

void normalise(std::vector<Explanation>& sets) {
  const double base = sets.front().logBayesFactor;  // the empty set with the stated noise
  double most = impossible, sum = 0;
  for (Explanation& set : sets) {
    set.logPosteriorOdds -= base;
    set.logBayesFactor -= base;
    most = std::max(most, set.logPosteriorOdds);
  }
  // Odds relative to the most likely set are at most 1. The logarithms themselves may be millions, and their
  // rounding would spoil the probabilities.
  for (Explanation& set : sets) sum += set.chance = std::exp(set.logPosteriorOdds - most);
  for (Explanation& set : sets) set.chance /= sum;
  std::ranges::sort(sets, std::greater{}, &Explanation::logPosteriorOdds);
}

/// Adds sets with larger noise to `all`, which holds the sets with the stated noise, the empty set first.
void addNoisy(std::vector<Explanation>& all, Search& search, const Leftover& leftover,
              const PriorOdds& odds) {
  const double f = leftover.degreesOfFreedom(), chiSquare = leftover.chiSquare();
  const auto scaleOf = [&](double left) {
    return std::clamp(std::sqrt(left / std::max(f, 1.0)), noise_policy::least, noise_policy::most);
  };
  const auto weigh = [&](Explanation& set, double reference) {
    set.logPosteriorOdds += std::log(odds.noise);
    weighNoisy(set, f, reference, chiSquare);
  };
  Explanation noiseAlone;
  noiseAlone.chiSquare = chiSquare;
  weigh(noiseAlone, scaleOf(chiSquare));
  // Larger noise gains most with the empty set, since an explanation leaves a smaller χ². For each of its few
  // weights, an explanation gains at most a factor of the noise scale in addition.
  if (noiseAlone.logPosteriorOdds < all.front().logPosteriorOdds + std::log(outOfQuestion)) {
    all.push_back(std::move(noiseAlone));
    return;
  }
  std::vector<double> references{scaleOf(chiSquare)};
  const double ofNamed = scaleOf(bestNamed(all).chiSquare);
  if (ofNamed < 0.8 * references.front()) references.push_back(ofNamed);
  std::vector<Explanation> noisy;
  for (const double reference : references)
    for (Explanation& set : search.grown(reference * reference)) {
      weigh(set, reference);
      const auto before =
          std::ranges::find_if(noisy, [&](const Explanation& other) { return areAlike(other, set); });
      if (before == noisy.end())
        noisy.push_back(std::move(set));
      else if (before->logPosteriorOdds < set.logPosteriorOdds)
        *before = std::move(set);
    }
  std::ranges::move(noisy, std::back_inserter(all));
}

}  // namespace

bool Part::isSupported() const {
  constexpr double something = 0.1;  // ln Bayes factor
  return logGain > something;
}

bool Explanation::has(std::size_t component) const {
  return std::ranges::find(parts, component, &Part::component) != parts.end();
}

bool isPartOf(const Explanation& smaller, const Explanation& larger) {
  return (!smaller.noisy || larger.noisy) &&
         std::ranges::all_of(smaller.parts, [&](const Part& part) { return larger.has(part.component); });
}

bool areAlike(const Explanation& a, const Explanation& b) {
  return a.noisy == b.noisy && a.parts.size() == b.parts.size() && isPartOf(a, b);
}

std::vector<Explanation> explain(const Leftover& leftover, const Candidates& candidates,
                                 const SearchOptions& options) {
  const double f = leftover.degreesOfFreedom();
  Search search(leftover, candidates, options);
  std::vector<Explanation> all = search.grown(1);
  for (Explanation& set : all) weighNominal(set, f);
  if (options.noise) addNoisy(all, search, leftover, options.odds);
  normalise(all);
  return all;
}

NoiseEvidence evidenceOfNoise(bool isLarger, double chiSquare, double degreesOfFreedom, double reference) {
  const NoiseScales& scales = isLarger ? largerScales() : nominalScales();
  NoiseEvidence evidence;
  evidence.log = scales.logIntegral(chiSquare, degreesOfFreedom, reference, evidence.likeliest);
  return evidence;
}

Part fitAlone(const SharedProducts& residual, const Component& component, std::size_t index) {
  const VectorXd right = component.products(residual);
  MatrixXd gram = component.gram();
  switch (component.response()) {
    case Response::Linear:
      break;
    case Response::Bent: {
      const BentFit fit = fitBent(component.widths(), gram, right, 1);
      return {index, fit.gain.width, fit.weights, fit.gain.log};
    }
    case Response::AllOrNothing:
      return {index, 1, VectorXd::Ones(1), right[0] - gram(0, 0) / 2};
  }
  const Gain gain = gainOf(component.widths(), gram, right, 1);
  gram.diagonal().array() += 1 / (gain.width * gain.width);
  return {index, gain.width, gram.ldlt().solve(right), gain.log};
}

}  // namespace alidade
