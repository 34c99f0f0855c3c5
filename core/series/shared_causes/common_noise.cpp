#include "core/series/shared_causes/common_noise.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>

#include "core/diagnosis/result/noise_policy.h"

namespace alidade {

namespace {

using noise_policy::knownTo;

/// The χ² and degrees of freedom that remain in the sessions of an instrument, one entry for each session.
struct Left {
  std::vector<std::size_t> sessions;
  std::vector<bool> isNoisy;  ///< the session's explanation already includes larger noise
  std::vector<double> chiSquares, f;

  double sumOfF() const { return std::accumulate(f.begin(), f.end(), 0.0); }
};

/// Log likelihood of a noise scale, up to a constant; `f`: degrees of freedom.
double logOf(double chiSquare, double f, double scale) {
  return -f * std::log(scale) - chiSquare / (2 * scale * scale);
}

/// A session that scatters independently of the others: its likeliest scale, and the logarithm of its prior
/// odds times its evidence (by Laplace's method, with a uniform prior in log scale).
struct OwnNoise {
  double scale = 1, log = 0;
};

OwnNoise ownNoise(const Left& left, std::size_t i) {
  const double f = std::max(left.f[i], 1.0);
  const double scale = std::clamp(std::sqrt(left.chiSquares[i] / f), noise_policy::least, noise_policy::most);
  const double spread = std::sqrt(M_PI / f) / std::log(noise_policy::most / noise_policy::least);
  return {scale, logOf(left.chiSquares[i], left.f[i], scale) + std::log(std::min(spread, 1.0)) +
                     std::log(noise_policy::odds / static_cast<double>(left.sessions.size()))};
}

double logSumOfTwo(double a, double b) {
  return std::max(a, b) + std::log1p(std::exp(-std::abs(a - b)));
}

/// The likeliest scale of a range, and the log evidence summed over the range.
struct Range {
  double likeliest = 1, log = -std::numeric_limits<double>::infinity();
};

/// `prior`: log density of the logarithm of the scale.
template <typename Prior>
Range weighed(const Left& left, double from, double to, const Prior& prior) {
  constexpr int steps = 200;
  const double step = (std::log(to) - std::log(from)) / steps;
  Range range;
  double most = range.log;
  for (int i = 0; i <= steps; ++i) {
    const double scale = from * std::exp(i * step);
    double log = std::log(step) + prior(std::log(scale));
    for (std::size_t s = 0; s < left.sessions.size(); ++s)
      log += logSumOfTwo(logOf(left.chiSquares[s], left.f[s], scale), ownNoise(left, s).log);
    range.log = std::isinf(range.log) ? log : logSumOfTwo(range.log, log);
    if (log <= most) continue;
    most = log;
    range.likeliest = scale;
  }
  return range;
}

/// Decides between noise as stated (within a tenth) and larger noise; noisy sessions become own entries.
std::vector<CommonNoise> noiseOf(const std::string& instrument, const Left& left) {
  constexpr double certain = 0.9;
  if (left.sumOfF() < 1) return {{.instrument = instrument, .sessions = left.sessions}};
  const Range asStated = weighed(left, std::exp(-4 * knownTo), std::exp(4 * knownTo), [](double log) {
    return -0.5 * std::pow(log / knownTo, 2) - std::log(knownTo * std::sqrt(2 * M_PI));
  });
  const Range larger = weighed(left, noise_policy::least, noise_policy::most, [](double) {
    return std::log(noise_policy::odds / std::log(noise_policy::most / noise_policy::least));
  });
  CommonNoise all{.instrument = instrument, .sessions = {}};
  all.probability = 1 / (1 + std::exp(std::clamp(asStated.log - larger.log, -700.0, 700.0)));
  all.isLarger = all.probability > certain;
  all.scale = all.isLarger ? larger.likeliest : std::max(asStated.likeliest, 1.0);
  std::vector<CommonNoise> list;
  double f = 0;
  for (std::size_t i = 0; i < left.sessions.size(); ++i) {
    const OwnNoise own = ownNoise(left, i);
    const double others = logOf(left.chiSquares[i], left.f[i], all.scale);
    const double chance = 1 / (1 + std::exp(std::clamp(others - own.log, -700.0, 700.0)));
    if (left.sessions.size() == 1 || chance <= certain || own.scale <= all.scale) {
      all.sessions.push_back(left.sessions[i]);
      f += left.f[i];
      continue;
    }
    if (left.isNoisy[i]) continue;
    list.push_back({.instrument = instrument,
                    .sessions = {left.sessions[i]},
                    .scale = own.scale,
                    .sigma = own.scale / std::sqrt(2 * std::max(left.f[i], 1.0)),
                    .isLarger = true,
                    .isOfOne = true,
                    .probability = chance});
  }
  all.sigma = all.scale / std::sqrt(2 * std::max(f, 1.0));
  list.insert(list.begin(), std::move(all));
  return list;
}

}  // namespace

double chiSquareLeft(const SessionSums& sums, std::size_t session, const SharedSet& set) {
  const std::size_t explanation = set.explanations[session];
  const SessionExplanation& own = sums.explanation(explanation);
  const double variance = std::pow(std::max(sums.noise(), own.noise), 2);
  double left = own.chiSquare;
  struct Share {
    const EffectColumns* columns;
    Eigen::VectorXd weights;
  };
  std::vector<Share> shares;
  for (const SharedPart& part : set.parts) {
    const auto found = std::ranges::lower_bound(part.block.sessions, session);
    if (found == part.block.sessions.end() || *found != session) continue;
    shares.push_back({&part.block.columns(),
                      part.weightsIn(static_cast<std::size_t>(found - part.block.sessions.begin()))});
  }
  for (const Share& a : shares) {
    left -= 2 * variance * sums.right(explanation, *a.columns).dot(a.weights);
    for (const Share& b : shares)
      left += variance * a.weights.dot(sums.normal(explanation, *a.columns, *b.columns) * b.weights);
  }
  return std::max(left, 0.0);
}

std::vector<CommonNoise> commonNoise(const std::vector<SessionSums>& sums,
                                     const std::vector<SessionOwners>& owners, const SharedSet& set) {
  std::map<std::string, Left> ofInstruments;
  for (std::size_t s = 0; s < sums.size(); ++s) {
    const SessionExplanation& explanation = sums[s].explanation(set.explanations[s]);
    if (owners[s].instrument.empty()) continue;
    Left& left = ofInstruments[owners[s].instrument];
    left.chiSquares.push_back(chiSquareLeft(sums[s], s, set));
    left.f.push_back(
        std::max(0, sums[s].evidence().degreesOfFreedom - static_cast<int>(explanation.directions)));
    left.isNoisy.push_back(explanation.noisy);
    left.sessions.push_back(s);
  }
  std::vector<CommonNoise> list;
  for (const auto& [instrument, left] : ofInstruments)
    std::ranges::move(noiseOf(instrument, left), std::back_inserter(list));
  return list;
}

}  // namespace alidade
