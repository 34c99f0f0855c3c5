#include "core/adjustment/monte_carlo/monte_carlo.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

#include "core/adjustment/monte_carlo/refit.h"
#include "core/base/statistics.h"
#include "core/base/threads.h"

namespace alidade {

namespace {

constexpr std::size_t fewestDraws = 100;
constexpr double chanceSigmas = 3;  // chance exceeds three standard uncertainties of an end once in 370 times

/// The fastest refit that is valid for the session.
class Refits {
 public:
  Refits(const RefitTask& task, std::uint64_t seed) : m_task(task) {
    m_areApart = arcsRefit(task) != nullptr;
    if (m_areApart) return;
    m_model = expandedModel(task);
    if (m_model && !holds(seed)) m_model = nullptr;
  }

  std::unique_ptr<Refit> make() const {
    if (m_areApart) return arcsRefit(m_task);
    return m_model ? expandedRefit(m_task, m_model) : generalRefit(m_task);
  }

 private:
  /// Does the expansion agree with the fit itself? Separate draws must agree to a thousandth of σ in every
  /// centre, which is at most a fifth of the numerical tolerance.
  bool holds(std::uint64_t seed) const {
    constexpr std::size_t probes = 64;
    constexpr std::uint64_t apart = std::uint64_t{1} << 63;
    constexpr double share = 1e-3;
    std::vector<Draw> draws(probes);
    for (std::size_t i = 0; i < probes; ++i) m_task.plan.drawInto(draws[i], seed, apart + i);
    std::vector<double> quick(probes * m_task.centres()), general = quick;
    expandedRefit(m_task, m_model)->refit(draws, quick);
    generalRefit(m_task)->refit(draws, general);
    for (std::size_t i = 0; i < quick.size(); ++i) {
      const std::size_t centre = i % m_task.centres();
      const ArcSigma& sigma = m_task.fit.sigmas[centre / 2];
      if (!(std::abs(quick[i] - general[i]) <= share * (centre % 2 == 0 ? sigma.x : sigma.y))) return false;
    }
    return true;
  }

  RefitTask m_task;
  bool m_areApart = false;
  std::shared_ptr<const ExpandedModel> m_model;
};

/// Δx0 Δy0 Δx1 Δy1 and Δd of the draws, a column for each.
class Columns {
 public:
  explicit Columns(const RefitTask& task) : m_values(task.centres() + (task.fit.intersection ? 1 : 0)) {
    if (!task.fit.intersection) return;
    m_upper = 2 * arcAt(task.fitted, 0).value() + 1;
    m_lower = 2 * arcAt(task.fitted, 180).value() + 1;
  }

  std::size_t draws() const { return m_values.front().size(); }
  std::vector<std::vector<double>>& values() { return m_values; }
  void resize(std::size_t draws) {
    for (std::vector<double>& column : m_values) column.resize(draws, missingCentre);
  }

  /// A draw is missing as a whole if any of its values is missing.
  void put(std::size_t draw, std::span<const double> centres) {
    const bool isThere = std::ranges::all_of(centres, [](double value) { return std::isfinite(value); });
    for (std::size_t i = 0; i < centres.size(); ++i) m_values[i][draw] = isThere ? centres[i] : missingCentre;
    if (m_values.size() > centres.size())
      m_values.back()[draw] = isThere ? (centres[m_upper] - centres[m_lower]) / 2 : missingCentre;
  }

  void dropMissing() {
    for (std::vector<double>& column : m_values)
      std::erase_if(column, [](double value) { return std::isnan(value); });
  }

 private:
  std::vector<std::vector<double>> m_values;
  std::size_t m_upper = 0, m_lower = 0;  ///< indices of Δy at 0° and at 180° among the centres
};

/// Makes draws `first` … `end` − 1 on all threads and appends them in this order. False if it was stopped.
bool drawAll(Columns& columns, std::size_t first, std::size_t end, const RefitTask& task,
             const Refits& refits, const MonteCarloOptions& options, const std::stop_token& stop) {
  constexpr std::size_t batch = 256;
  const std::size_t held = columns.draws(), count = end - first;
  columns.resize(held + count);
  const std::size_t batches = (count + batch - 1) / batch;
  std::atomic<std::size_t> next = 0;
  inThreads(threadsOrAll(options.threads), [&] {
    const auto refit = refits.make();
    std::vector<Draw> draws(batch);
    std::vector<double> centres(batch * task.centres());
    for (std::size_t turn; (turn = next++) < batches && !stop.stop_requested();) {
      const std::size_t from = turn * batch, taken = std::min(batch, count - from);
      for (std::size_t i = 0; i < taken; ++i) task.plan.drawInto(draws[i], options.seed, first + from + i);
      const std::span<double> found(centres.data(), taken * task.centres());
      refit->refit(std::span(draws).first(taken), found);
      for (std::size_t i = 0; i < taken; ++i)
        columns.put(held + from + i, found.subspan(i * task.centres(), task.centres()));
      if (options.made) *options.made += taken;
    }
  });
  columns.dropMissing();
  return !stop.stop_requested();
}

/// The value at `rank` in order of size. Sorts only the values beyond one σ if the rank is among them.
double valueAt(const std::vector<double>& values, std::size_t rank, const Spread& spread) {
  const bool isLow = 2 * rank < values.size();
  const double bound = isLow ? spread.mean - spread.sigma : spread.mean + spread.sigma;
  std::vector<double> beyond;
  beyond.reserve(values.size() / 4);
  for (const double value : values)
    if (isLow ? value < bound : value > bound) beyond.push_back(value);
  const std::size_t fromAbove = values.size() - 1 - rank;
  const std::size_t own = isLow ? rank : beyond.size() - 1 - fromAbove;
  if ((isLow ? rank : fromAbove) < beyond.size()) {
    std::ranges::nth_element(beyond, beyond.begin() + static_cast<std::ptrdiff_t>(own));
    return beyond[own];
  }
  beyond = values;
  std::ranges::nth_element(beyond, beyond.begin() + static_cast<std::ptrdiff_t>(rank));
  return beyond[rank];
}

/// Computes the spread of at least two values.
Spread spreadOf(const std::vector<double>& values, double coverage) {
  const auto count = static_cast<double>(values.size());
  Spread spread;
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.sigma = std::sqrt(squares / (count - 1));
  const auto inside = static_cast<std::size_t>(std::llround(coverage * count));
  const std::size_t outside = values.size() - inside, below = outside > 0 ? (outside - 1) / 2 : 0;
  spread.low = valueAt(values, below, spread);
  spread.high = valueAt(values, std::min(below + inside, values.size() - 1), spread);
  return spread;
}

/// Returns half a unit of the second significant digit of σ.
double numericalTolerance(double sigma) {
  return sigma > 0 ? 0.5 * std::pow(10, std::floor(std::log10(sigma)) - 1) : 0;
}

/// Standard uncertainty of the end of an interval beyond which lies the share p = (1 − coverage)/2 of M
/// draws: √(p(1 − p)/M)/density. The density is that of a normal distribution with this σ.
double endpointSigma(double coverage, double sigma, std::size_t draws) {
  const double outside = (1 - coverage) / 2;
  const double z = normalQuantile(1 - outside);
  const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::acos(-1.0)) / sigma;
  return std::sqrt(outside * (1 - outside) / static_cast<double>(draws)) / density;
}

double worstOf(const MonteCarlo& result) {
  return std::max(result.lowDifference, result.highDifference);
}

void compare(MonteCarlo& result, const Intersection& intersection) {
  const Spread& spread = *result.intersection;
  result.tolerance = numericalTolerance(intersection.sigma);
  result.lowDifference = std::abs(intersection.value - intersection.expanded - spread.low);
  result.highDifference = std::abs(intersection.value + intersection.expanded - spread.high);
  result.endpointSigma = endpointSigma(result.coverage, spread.sigma, result.draws);
  const double worst = worstOf(result), chance = chanceSigmas * result.endpointSigma;
  if (worst > result.tolerance + chance)
    result.linear = LinearPropagation::Refuted;
  else if (worst <= result.tolerance && chance <= result.tolerance)
    result.linear = LinearPropagation::Validated;
}

MonteCarlo resultOf(Columns& columns, const RefitTask& task, std::size_t drawn,
                    const MonteCarloOptions& options) {
  MonteCarlo result;
  result.draws = columns.draws();
  result.failed = drawn - result.draws;
  result.seed = options.seed;
  result.coverage = task.fitted.coverage;
  if (result.draws < fewestDraws) return result;
  std::vector<Spread> spreads(columns.values().size());
  doEach(threadsOrAll(options.threads), spreads.size(),
         [&](std::size_t i) { spreads[i] = spreadOf(columns.values()[i], result.coverage); });
  const std::vector<std::size_t> firsts = firstAtTheirAxes(task.fitted);
  for (std::size_t i = 0; i < firsts.size(); ++i)
    if (firsts[i] == i)
      result.centres.push_back({task.fitted.arcs[i].axisDeg, spreads[2 * i], spreads[2 * i + 1]});
  if (task.fit.intersection) {
    result.intersection = spreads.back();
    compare(result, *task.fit.intersection);
  }
  return result;
}

bool isAnswered(const MonteCarlo& result) {
  return !result.intersection || result.linear != LinearPropagation::Undecided;
}

/// The number of draws needed for a decision, at least twice the draws so far. Three standard uncertainties
/// of an end must fit within the tolerance. If an end differs by more than the tolerance, they must also fit
/// within the excess.
std::size_t drawsToDecide(const MonteCarlo& result, std::size_t drawn) {
  const double excess = worstOf(result) - result.tolerance;
  const double room = excess > 0 ? std::min(result.tolerance, excess) : result.tolerance;
  const double ratio = chanceSigmas * result.endpointSigma / room;
  const double wanted = 1.1 * static_cast<double>(drawn) * ratio * ratio;
  const double most = static_cast<double>(mostDrawsLeftOpen);
  return static_cast<std::size_t>(std::min(most, std::max(2.0 * static_cast<double>(drawn), wanted)));
}

}  // namespace

std::optional<MonteCarlo> propagateDistributions(const Measurement& measurement, const SessionFit& fit,
                                                 const MonteCarloOptions& options,
                                                 const std::stop_token& stop) {
  const Measurement fitted = fittedPart(measurement, fit);
  if (fitted.arcs.empty()) return std::nullopt;
  const DrawPlan plan(fitted, fit.noise);
  const RefitTask task{fitted, fit, plan};
  const Refits refits(task, options.seed);
  Columns columns(task);
  constexpr std::size_t firstDraws = 20000;
  for (std::size_t drawn = 0, wanted = options.draws.value_or(firstDraws);;) {
    if (!drawAll(columns, drawn, wanted, task, refits, options, stop)) return std::nullopt;
    drawn = wanted;
    MonteCarlo result = resultOf(columns, task, drawn, options);
    if (result.draws < fewestDraws) return std::nullopt;
    if (options.draws || isAnswered(result)) return result;
    if (drawn == mostDrawsLeftOpen) {  // an end is so near the tolerance that chance prevents a decision
      result.linear =
          worstOf(result) <= result.tolerance ? LinearPropagation::Validated : LinearPropagation::Refuted;
      return result;
    }
    wanted = drawsToDecide(result, drawn);
  }
}

}  // namespace alidade
