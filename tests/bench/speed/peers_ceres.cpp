#include <benchmark/benchmark.h>
#include <ceres/ceres.h>
#include <ceres/tiny_solver.h>

#include <array>
#include <cmath>

#include "core/observation/perfect_theodolite.h"
#include "tests/bench/speed/answers.h"
#include "tests/bench/speed/readings.h"

// The peers in C++: Ceres and its TinySolver on the same readings, tuned. The arc angles are eliminated
// (variable projection), which leaves 3 unknowns. Each point has one residual, its distance from the arc in
// units of σ, with its exact derivative. There is one cost function for all points, with dense normal
// equations and no logging. The sum of squares equals that of the readings' residuals.

namespace alidade::bench {
namespace {

struct Distance {
  double value = 0;
  std::array<double, 3> perUnknown{};
};

/// The distance of one pair of readings from the arc, in σ. Gauss-Newton iterates the foot point to rounding.
Distance distanceOf(const ArcSetup& setup, const double* circle, double a, double e) {
  const auto [x, y] = sightedPoint({a, e}, setup.distance, setup.relation);
  const double length = setup.distance;
  double phi = std::atan2(y - circle[1], x - circle[0]);
  for (int step = 0;; ++step) {
    const double c = std::cos(phi), s = std::sin(phi);
    const double px = circle[0] + circle[2] * c, py = circle[1] + circle[2] * s;
    const double ground = std::sqrt(px * px + length * length), slant = ground * ground + py * py;
    const double left = (a - std::atan2(px, length)) / setup.sigmaHorizontal,
                 over = (e - std::atan2(py, ground)) / setup.sigmaVertical;
    const double aX = length / (ground * ground) / setup.sigmaHorizontal;
    const double eX = -py * px / (ground * slant) / setup.sigmaVertical,
                 eY = ground / slant / setup.sigmaVertical;
    const double aPhi = -circle[2] * s * aX, ePhi = circle[2] * (c * eY - s * eX);
    const double along = aPhi * aPhi + ePhi * ePhi;
    if (step == 2) {
      const double length1 = std::sqrt(along), u = ePhi / length1, v = -aPhi / length1;  // across the arc
      const double perX = u * aX + v * eX, perY = v * eY;
      return {u * left + v * over, {-perX, -perY, -(perX * c + perY * s)}};
    }
    phi += (left * aPhi + over * ePhi) / along;
  }
}

struct Arc {
  ArcSetup setup = usualSetup();
  std::span<const double> a, e;
};

Arc arcAt(std::size_t index) {
  return {.a = shortArcs().horizontal(index * pointsOfArc, pointsOfArc),
          .e = shortArcs().vertical(index * pointsOfArc, pointsOfArc)};
}

/// Kåsa's circle, the start of this program's fits.
std::array<double, 3> startOf(const Arc& arc) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < arc.a.size(); ++i) {
    const auto [x, y] = sightedPoint({arc.a[i], arc.e[i]}, arc.setup.distance, arc.setup.relation);
    const Eigen::Vector3d row(2 * x, 2 * y, 1);
    normal += row * row.transpose();
    right += row * (x * x + y * y);
  }
  const Eigen::Vector3d found = normal.ldlt().solve(right);
  return {found[0], found[1], std::sqrt(found[2] + found[0] * found[0] + found[1] * found[1])};
}

class ArcCost : public ceres::CostFunction {
 public:
  explicit ArcCost(const Arc& arc) : m_arc(arc) {
    set_num_residuals(static_cast<int>(arc.a.size()));
    *mutable_parameter_block_sizes() = {3};
  }

  bool Evaluate(const double* const* unknowns, double* residuals, double** jacobians) const override {
    for (std::size_t i = 0; i < m_arc.a.size(); ++i) {
      const Distance distance = distanceOf(m_arc.setup, unknowns[0], m_arc.a[i], m_arc.e[i]);
      residuals[i] = distance.value;
      if (jacobians && jacobians[0])
        for (std::size_t k = 0; k < 3; ++k) jacobians[0][3 * i + k] = distance.perUnknown[k];
    }
    return true;
  }

 private:
  Arc m_arc;
};

struct CeresFit {
  std::array<double, 3> circle;
  std::array<double, 9> covariance{};
};

CeresFit fitWithCeres(const Arc& arc) {
  CeresFit fit{startOf(arc)};
  ArcCost cost(arc);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.disable_all_safety_checks = true;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&cost, nullptr, fit.circle.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.logging_type = ceres::SILENT;
  options.initial_trust_region_radius = 1e16;
  options.function_tolerance = 1e-14;
  options.max_num_iterations = 10;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  ceres::Covariance::Options covarianceOptions;
  covarianceOptions.algorithm_type = ceres::DENSE_SVD;
  ceres::Covariance covariance(covarianceOptions);
  const std::vector<std::pair<const double*, const double*>> blocks{{fit.circle.data(), fit.circle.data()}};
  if (covariance.Compute(blocks, &problem))
    covariance.GetCovarianceBlock(fit.circle.data(), fit.circle.data(), fit.covariance.data());
  return fit;
}

Circle circleOf(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

/// An arc for TinySolver, which keeps the normal equations private, so that there is no covariance.
struct TinyArc {
  using Scalar = double;
  enum { NUM_RESIDUALS = pointsOfArc, NUM_PARAMETERS = 3 };

  bool operator()(const double* unknowns, double* residuals, double* jacobian) const {
    for (std::size_t i = 0; i < pointsOfArc; ++i) {
      const Distance distance = distanceOf(arc.setup, unknowns, arc.a[i], arc.e[i]);
      residuals[i] = distance.value;
      if (jacobian)
        for (std::size_t k = 0; k < 3; ++k) jacobian[i + pointsOfArc * k] = distance.perUnknown[k];
    }
    return true;
  }

  const Arc& arc;
};

Circle fitWithTinySolver(const Arc& arc) {
  const std::array<double, 3> start = startOf(arc);
  Eigen::Vector3d unknowns(start.data());
  ceres::TinySolver<TinyArc> solver;
  solver.options.gradient_tolerance = 1e-9;
  solver.options.initial_trust_region_radius = 1e16;
  solver.Solve(TinyArc{arc}, &unknowns);
  return {unknowns[0], unknowns[1], unknowns[2]};
}

void oneArcCeres(benchmark::State& state) {
  const Arc arc = arcAt(0);
  CeresFit fit;
  for (auto _ : state) benchmark::DoNotOptimize(fit = fitWithCeres(arc));
  answer(state, circleOf(fit.circle));
}
BENCHMARK(oneArcCeres)->Name("W1/Ceres");

void oneArcTiny(benchmark::State& state) {
  const Arc arc = arcAt(0);
  Circle circle;
  for (auto _ : state) benchmark::DoNotOptimize(circle = fitWithTinySolver(arc));
  answer(state, circle);
}
BENCHMARK(oneArcTiny)->Name("W1/TinySolver");

void twoArcsCeres(benchmark::State& state) {
  const Arc upper = arcAt(0), lower = arcAt(1);
  double intersection = 0;
  for (auto _ : state) {
    intersection = (fitWithCeres(upper).circle[1] - fitWithCeres(lower).circle[1]) / 2;
    benchmark::DoNotOptimize(intersection);
  }
  state.counters["intersection"] = intersection;
}
BENCHMARK(twoArcsCeres)->Name("W2/Ceres");

template <typename Fit>
void manyArcsWith(benchmark::State& state, Fit&& fit) {
  MeanCircle mean;
  for (auto _ : state) {
    mean = {};
    for (std::size_t i = 0; i < peerArcs; ++i) mean.add(fit(arcAt(i)));
    benchmark::DoNotOptimize(mean);
  }
  state.counters["each"] = static_cast<double>(peerArcs);
  answer(state, mean.value());
}

void manyArcsCeres(benchmark::State& state) {
  manyArcsWith(state, [](const Arc& arc) { return circleOf(fitWithCeres(arc).circle); });
}
BENCHMARK(manyArcsCeres)->Name("W3/Ceres")->Unit(benchmark::kMillisecond);

void manyArcsTiny(benchmark::State& state) {
  manyArcsWith(state, [](const Arc& arc) { return fitWithTinySolver(arc); });
}
BENCHMARK(manyArcsTiny)->Name("W3/TinySolver")->Unit(benchmark::kMillisecond);

void longArcCeres(benchmark::State& state) {
  const Arc arc{.a = longArc().a, .e = longArc().e};
  CeresFit fit;
  for (auto _ : state) benchmark::DoNotOptimize(fit = fitWithCeres(arc));
  state.counters["each"] = static_cast<double>(manyPoints);
  answer(state, circleOf(fit.circle));
}
BENCHMARK(longArcCeres)->Name("W4/Ceres")->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alidade::bench
