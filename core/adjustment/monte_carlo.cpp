#include "core/adjustment/monte_carlo.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <thread>

#include "core/base/random_source.h"

namespace alidade {

namespace {

constexpr std::size_t fewestDraws = 100;
constexpr double farBelowScatter = 1e-6;  // of the draws, which is some 1 σ
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// χ² with `freedom` ≥ 1 degrees of freedom: twice a Gamma variable (Marsaglia and Tsang, "A simple method
/// for generating gamma variables", 2000), raised to a shape above 1 where it is below.
double drawChiSquare(RandomSource& random, double freedom) {
  const bool raised = freedom < 2;
  const double d = freedom / 2 + (raised ? 1 : 0) - 1.0 / 3, c = 1 / std::sqrt(9 * d);
  while (true) {
    const double x = random.normal();
    const double v = std::pow(1 + c * x, 3);
    const double u = random.uniform();
    if (v > 0 && std::log(u) < x * x / 2 + d - d * v + d * std::log(v))
      return 2 * d * v * (raised ? std::pow(random.uniform(), 2 / freedom) : 1);
  }
}

/// One thread's place to draw in: readings and fit options, refilled for every draw.
class Drawing {
 public:
  Drawing(const Measurement& fitted, const SessionFit& fit)
      : m_read(fitted),
        m_drawn(fitted),
        m_fit(fit),
        m_options{.terms = estimatedTerms(fitted), .maximumIterations = 300, .tolerance = farBelowScatter} {
    for (const ArcFit& arc : fit.arcs) m_starts.push_back(arc.circle);
    m_terms = m_options.terms;
    const auto hasSlider = [](const ArcMeasurement& arc) {
      return std::ranges::any_of(arc.sightings, [](const Sighting& s) { return s.slider.has_value(); });
    };
    m_arcsApart = m_terms.empty() && fitted.radiusModel == RadiusModel::Free &&
                  std::ranges::none_of(fitted.arcs, hasSlider);
  }

  /// x and y of each arc, Δx0 Δy0 Δx1 …; NaN where the readings fix no circle.
  void drawInto(double* centres, RandomSource random) {
    draw(random);
    m_arcsApart ? fitApart(centres) : fitTogether(centres);
  }

 private:
  void draw(RandomSource& random) {
    double scale = m_fit.noise.factor;
    const double freedom = m_fit.noise.degreesOfFreedom;
    if (std::isfinite(freedom)) scale /= std::sqrt(drawChiSquare(random, freedom) / freedom);
    m_drawn.distance = m_read.distance + m_read.sigmaDistance * random.normal();
    if (m_read.radiusModel == RadiusModel::Known)
      m_drawn.nominalRadius = m_read.nominalRadius + m_read.sigmaRadius * random.normal();
    for (std::size_t t = 0; t < m_terms.size(); ++t)
      m_options.terms[t].priorValue = m_terms[t].priorSigma * scale * random.normal();
    for (std::size_t arc = 0; arc < m_read.arcs.size(); ++arc) drawArc(arc, scale, random);
  }

  void drawArc(std::size_t arc, double scale, RandomSource& random) {
    const Angle zeroA = m_read.sigmaZeroHorizontal * random.normal();
    const Angle zeroE = m_read.sigmaZeroVertical * random.normal();
    for (std::size_t i = 0; i < m_read.arcs[arc].sightings.size(); ++i) {
      const Sighting& read = m_read.arcs[arc].sightings[i];
      Sighting& drawn = m_drawn.arcs[arc].sightings[i];
      drawn.a = read.a + zeroA + m_read.sigmaHorizontal * (scale * random.normal());
      drawn.e = read.e + zeroE + m_read.sigmaVertical * (scale * random.normal());
      if (read.slider) drawn.slider = *read.slider + m_read.sigmaSlider * (scale * random.normal());
    }
  }

  void fitApart(double* centres) const {
    for (std::size_t i = 0; i < m_drawn.arcs.size(); ++i) {
      const Result<ArcFit> fit =
          fitArc(m_drawn, m_drawn.arcs[i], {.start = m_starts[i], .tolerance = farBelowScatter});
      const bool found = fit && fit->converged;
      centres[2 * i] = found ? fit->circle.x : missing;
      centres[2 * i + 1] = found ? fit->circle.y : missing;
    }
  }

  void fitTogether(double* centres) const {
    const JointFit fit = fitJointly(m_drawn, m_starts, m_options);
    for (std::size_t i = 0; i < m_drawn.arcs.size(); ++i) {
      const auto value = [&](Unknown::Kind kind) {
        return fit.converged ? fit.values[fit.indexOf({.kind = kind, .arc = i})] : missing;
      };
      centres[2 * i] = value(Unknown::Kind::CentreX);
      centres[2 * i + 1] = value(Unknown::Kind::CentreY);
    }
  }

  const Measurement& m_read;
  Measurement m_drawn;
  const SessionFit& m_fit;
  JointFitOptions m_options;
  std::vector<EstimatedTerm> m_terms;
  std::vector<Circle> m_starts;
  bool m_arcsApart = false;
};

/// Every draw by its number, whichever thread takes it. False where it was stopped.
bool drawAll(std::vector<double>& centres, const Measurement& fitted, const SessionFit& fit,
             const MonteCarloOptions& options, const std::stop_token& stop) {
  constexpr std::size_t batch = 64;
  const std::size_t width = 2 * fitted.arcs.size();
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    Drawing drawing(fitted, fit);
    for (std::size_t first; (first = next.fetch_add(batch)) < options.draws;) {
      if (stop.stop_requested()) return;
      const std::size_t end = std::min(first + batch, options.draws);
      for (std::size_t i = first; i < end; ++i)
        drawing.drawInto(&centres[i * width], RandomSource(options.seed, i));
      if (options.made) *options.made += end - first;
    }
  };
  const unsigned threads =
      options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(work);
    work();
  }
  return !stop.stop_requested();
}

/// Sorts `values`, of which there are at least two.
Spread spreadOf(std::vector<double>& values, double coverage) {
  const auto count = static_cast<double>(values.size());
  Spread spread;
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.sigma = std::sqrt(squares / (count - 1));
  std::ranges::sort(values);
  const auto inside = static_cast<std::size_t>(std::llround(coverage * count));
  const std::size_t below = (values.size() - inside) / 2;
  spread.low = values[below];
  spread.high = values[std::min(below + inside, values.size() - 1)];
  return spread;
}

/// Half a unit of the second significant digit of σ.
double numericalTolerance(double sigma) {
  return sigma > 0 ? 0.5 * std::pow(10, std::floor(std::log10(sigma)) - 1) : 0;
}

/// Of the end of an interval with a share of (1 − coverage)/2 beyond it: √(p(1 − p)/M)/density, the density
/// of the normal distribution of that σ.
double endpointSigma(double coverage, double sigma, std::size_t draws) {
  const double outside = (1 - coverage) / 2;
  const double z = normalQuantile(1 - outside);
  const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::acos(-1.0)) / sigma;
  return std::sqrt(outside * (1 - outside) / static_cast<double>(draws)) / density;
}

void compare(MonteCarlo& result, const Intersection& intersection) {
  const Spread& spread = *result.intersection;
  result.tolerance = numericalTolerance(intersection.sigma);
  result.lowDifference = std::abs(intersection.value - intersection.expanded - spread.low);
  result.highDifference = std::abs(intersection.value + intersection.expanded - spread.high);
  result.endpointSigma = endpointSigma(result.coverage, spread.sigma, result.draws);
  const double worst = std::max(result.lowDifference, result.highDifference);
  // Chance moves an end by three of its standard uncertainties once in 370 times.
  const double chance = 3 * result.endpointSigma;
  if (worst > result.tolerance + chance)
    result.linear = LinearPropagation::Refuted;
  else if (worst <= result.tolerance && chance <= result.tolerance)
    result.linear = LinearPropagation::Validated;
}

/// Column by column; draws without a result are left out of all of them.
std::vector<std::vector<double>> columnsOf(const std::vector<double>& centres, std::size_t width) {
  std::vector<std::vector<double>> columns(width);
  for (std::size_t row = 0; row + width <= centres.size(); row += width) {
    const auto begin = centres.begin() + static_cast<std::ptrdiff_t>(row);
    if (std::any_of(begin, begin + static_cast<std::ptrdiff_t>(width),
                    [](double value) { return !std::isfinite(value); }))
      continue;
    for (std::size_t i = 0; i < width; ++i) columns[i].push_back(centres[row + i]);
  }
  return columns;
}

}  // namespace

std::optional<MonteCarlo> propagateDistributions(const Measurement& measurement, const SessionFit& fit,
                                                 const MonteCarloOptions& options,
                                                 const std::stop_token& stop) {
  const Measurement fitted = fittedPart(measurement, fit);
  if (fitted.arcs.empty()) return std::nullopt;
  const std::size_t width = 2 * fitted.arcs.size();
  std::vector<double> centres(options.draws * width, missing);
  if (!drawAll(centres, fitted, fit, options, stop)) return std::nullopt;
  std::vector<std::vector<double>> columns = columnsOf(centres, width);

  MonteCarlo result;
  result.draws = columns.front().size();
  result.failed = options.draws - result.draws;
  result.seed = options.seed;
  result.coverage = measurement.coverage;
  if (result.draws < fewestDraws) return std::nullopt;
  if (fit.intersection) {
    const std::size_t upper = fitted.arcs[0].axisDeg == 0 ? 1 : 3, lower = 4 - upper;
    std::vector<double> differences;
    for (std::size_t i = 0; i < result.draws; ++i)
      differences.push_back((columns[upper][i] - columns[lower][i]) / 2);
    result.intersection = spreadOf(differences, result.coverage);
    compare(result, *fit.intersection);
  }
  for (std::size_t i = 0; i < fitted.arcs.size(); ++i)
    result.centres.push_back({fitted.arcs[i].axisDeg, spreadOf(columns[2 * i], result.coverage),
                              spreadOf(columns[2 * i + 1], result.coverage)});
  return result;
}

}  // namespace alidade
