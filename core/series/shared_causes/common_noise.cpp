#include "core/series/shared_causes/common_noise.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace alidade {

namespace {

constexpr double knownTo = 0.1;  // the stated σ holds to a tenth
constexpr double leastNoise = 1.25, mostNoise = 20;
constexpr double noiseOdds = 0.04;  // larger than stated

struct Left {
  double chiSquare = 0, f = 0;
  std::vector<std::size_t> sessions;
};

/// −f ln scale − ½ χ²/scale².
double logOf(const Left& left, double scale) {
  return -left.f * std::log(scale) - left.chiSquare / (2 * scale * scale);
}

/// The likeliest scale that is a tenth off at 1σ, by Newton's steps of its logarithm.
double nominalScale(const Left& left) {
  double log = 0;
  for (int i = 0; i < 30; ++i) {
    const double rest = left.chiSquare * std::exp(-2 * log);
    const double slope = -left.f + rest - log / (knownTo * knownTo),
                 curvature = 2 * rest + 1 / (knownTo * knownTo);
    log += slope / curvature;
  }
  return std::exp(std::clamp(log, -4 * knownTo, 4 * knownTo));
}

CommonNoise noiseOf(const std::string& instrument, const Left& left) {
  CommonNoise noise{.instrument = instrument, .sessions = left.sessions};
  if (left.f < 1) return noise;
  const double nominal = nominalScale(left), log = std::log(nominal);
  const double width = 1 / std::sqrt(2 * left.f + 1 / (knownTo * knownTo));
  const double asStated = logOf(left, nominal) - 0.5 * std::pow(log / knownTo, 2) + std::log(width / knownTo);
  const double larger = std::clamp(std::sqrt(left.chiSquare / left.f), leastNoise, mostNoise);
  const double spread = std::sqrt(M_PI / left.f) / std::log(mostNoise / leastNoise);
  const double asLarger = logOf(left, larger) + std::log(std::min(spread, 1.0)) + std::log(noiseOdds);
  noise.probability = 1 / (1 + std::exp(std::clamp(asStated - asLarger, -700.0, 700.0)));
  noise.isLarger = noise.probability > 0.9;
  noise.scale = noise.isLarger ? larger : std::max(nominal, 1.0);
  noise.sigma = noise.scale / std::sqrt(2 * left.f);
  return noise;
}

}  // namespace

double chiSquareLeft(const SessionSums& sums, std::size_t session, const SharedSet& set) {
  const std::size_t account = set.accounts[session];
  const OwnAccount& own = sums.account(account);
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
    left -= 2 * variance * sums.right(account, *a.columns).dot(a.weights);
    for (const Share& b : shares)
      left += variance * a.weights.dot(sums.normal(account, *a.columns, *b.columns) * b.weights);
  }
  return std::max(left, 0.0);
}

std::vector<CommonNoise> commonNoise(const std::vector<SessionSums>& sums,
                                     const std::vector<SessionOwners>& owners, const SharedSet& set) {
  std::map<std::string, Left> ofInstruments;
  for (std::size_t s = 0; s < sums.size(); ++s) {
    const OwnAccount& account = sums[s].account(set.accounts[s]);
    if (account.noisy || owners[s].instrument.empty()) continue;
    Left& left = ofInstruments[owners[s].instrument];
    left.chiSquare += chiSquareLeft(sums[s], s, set);
    left.f += std::max(0, sums[s].evidence().degreesOfFreedom - static_cast<int>(account.directions));
    left.sessions.push_back(s);
  }
  std::vector<CommonNoise> list;
  for (const auto& [instrument, left] : ofInstruments) list.push_back(noiseOf(instrument, left));
  return list;
}

}  // namespace alidade
