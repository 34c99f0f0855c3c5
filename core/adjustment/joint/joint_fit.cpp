#include "core/adjustment/joint/joint_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/adjustment/joint/fast_joint_fit.h"
#include "core/adjustment/joint/joint_problem.h"
#include "core/observation/half_turn.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Scaled to a unit diagonal before it is factored: millimetres and radians differ by 1e6 in size.
VectorXd solveScaled(const MatrixXd& matrix, const VectorXd& rightSide) {
  const VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  return scale.cwiseProduct(scaled.ldlt().solve(scale.cwiseProduct(rightSide)));
}

MatrixXd inverseScaled(const MatrixXd& matrix) {
  const VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  const MatrixXd inverse = scaled.ldlt().solve(MatrixXd::Identity(matrix.rows(), matrix.cols()));
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

struct Minimum {
  JointState state;
  JointSystem system;
  int iterations = 0;
  bool converged = false;
};

double remainingStep(const JointSystem& system, Index estimated) {
  const VectorXd rightSide = system.rightSide.head(estimated);
  const double squared =
      rightSide.dot(solveScaled(system.matrix.topLeftCorner(estimated, estimated), rightSide));
  return squared >= 0 ? std::sqrt(squared) : std::numeric_limits<double>::infinity();
}

Minimum minimise(const JointProblem& problem, JointState start, const JointFitOptions& options) {
  Minimum best{std::move(start), {}, 0, false};
  best.system = problem.system(best.state);
  const auto estimated = static_cast<Index>(problem.estimated().size());
  constexpr double largestDamping = 1e9, smallestDamping = 1e-12;
  constexpr double rounding = 1e-9;  // readings are rounded to some 1e-11 of their σ
  double damping = 1e-9;
  double previousStep = std::numeric_limits<double>::infinity();
  JointSystem spare;
  while (best.iterations < options.maximumIterations && damping < largestDamping) {
    ++best.iterations;
    MatrixXd damped = best.system.matrix.topLeftCorner(estimated, estimated);
    damped.diagonal() *= 1 + damping;
    JointState trial = problem.moved(best.state, best.system.equations,
                                     solveScaled(damped, best.system.rightSide.head(estimated)));
    JointSystem system = problem.system(trial, std::move(spare));
    if (system.chiSquare <= best.system.chiSquare + rounding * (1 + best.system.chiSquare)) {
      best.state = std::move(trial);
      spare = std::exchange(best.system, std::move(system));
      damping = std::max(damping / 10, smallestDamping);
      const double remaining = remainingStep(best.system, estimated);
      best.converged = remaining < options.tolerance && previousStep < 1e-4;
      if (best.converged) break;
      previousStep = remaining;
    } else {
      spare = std::move(system);
      damping *= 10;
    }
  }
  return best;
}

SquareMatrix plain(const MatrixXd& matrix) {
  SquareMatrix result{static_cast<std::size_t>(matrix.rows()), {}};
  for (Index i = 0; i < matrix.rows(); ++i)
    for (Index j = 0; j < matrix.cols(); ++j) result.values.push_back((matrix(i, j) + matrix(j, i)) / 2);
  return result;
}

/// ∂Δd/∂unknowns: half the difference of the heights of the centres at 0° and 180°.
VectorXd intersectionGradient(const Measurement& measurement, const std::vector<Unknown>& unknowns) {
  VectorXd gradient = VectorXd::Zero(static_cast<Index>(unknowns.size()));
  if (measurement.arcs.size() != 2) return gradient;
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    if (unknowns[i].kind == Unknown::Kind::CentreY)
      gradient[static_cast<Index>(i)] = intersectionPerHeight(measurement.arcs[unknowns[i].arc].axisDeg);
  return gradient;
}

/// The error terms come last among the estimated unknowns; theirs are zeros.
MatrixXd withoutTerms(const MatrixXd& normalMatrix, const JointProblem& problem) {
  const auto isTerm = [](const Unknown& unknown) { return unknown.kind == Unknown::Kind::Error; };
  const auto estimated = static_cast<Index>(problem.estimated().size());
  const Index others = estimated - std::ranges::count_if(problem.estimated(), isTerm);
  MatrixXd cofactor = MatrixXd::Zero(estimated, estimated);
  cofactor.topLeftCorner(others, others) = inverseScaled(normalMatrix.topLeftCorner(others, others));
  return cofactor;
}

std::vector<std::vector<double>> anglesOfSightings(const Measurement& measurement,
                                                   const JointProblem& problem, const JointState& state) {
  std::vector<std::vector<double>> angles;
  for (const ArcMeasurement& arc : measurement.arcs) angles.emplace_back(arc.sightings.size());
  for (std::size_t v = 0; v < problem.visits().size(); ++v) {
    const Angle phi = wrapped(Angle::fromRadians(state.arcAngles[static_cast<Index>(v)]));
    for (const std::size_t i : problem.visits()[v].visit.sightings)
      angles[problem.visits()[v].arc][i] = phi.radians();
  }
  return angles;
}

void fillReadings(JointFit& fit, const Measurement& measurement, const JointProblem& problem,
                  const std::vector<VisitEquations>& all, const MatrixXd& cofactor) {
  const VectorXd gradient = cofactor * intersectionGradient(measurement, fit.unknowns);
  std::vector<SlotMatrix> cofactors;
  std::vector<Slots> gradients;
  for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc) {
    cofactors.push_back(problem.gathered(cofactor, arc));
    gradients.push_back(problem.gathered(gradient, arc));
  }
  for (std::size_t v = 0; v < problem.visits().size(); ++v) {
    const VisitEquations& equations = all[v];
    const std::size_t arc = problem.visits()[v].arc;
    ArcMisfit& misfit = fit.misfits[arc];
    misfit.chiSquare += equations.residual.squaredNorm();
    const VisitEquations::Jacobian columns = JointProblem::reduced(equations);
    misfit.degreesOfFreedom -= equations.along.isZero(0) ? 0 : 1;
    for (Index row = 0; row < equations.residual.size(); ++row) {
      const Slots reduced = columns.row(row).transpose();
      const Slots turned = cofactors[arc].lazyProduct(reduced);
      const ReadingRef cell = problem.cellOf(v, row);
      AdjustedReading reading{.arc = cell.arc, .sighting = cell.sighting, .kind = cell.kind};
      reading.sigma = statedSigma(measurement, cell.kind).radians();
      reading.residual = equations.residual[row] * reading.sigma;
      const bool takesPart = !equations.jacobian.row(row).isZero(0);
      misfit.degreesOfFreedom += takesPart ? 1 : 0;
      reading.redundancy =
          (takesPart ? 1 : 0) - equations.along[row] * equations.along[row] - reduced.dot(turned);
      reading.perReading = gradients[arc].dot(reduced) / reading.sigma;
      fit.readings.push_back(reading);
    }
  }
}

/// What is counted in χ² less what is estimated; an unknown with a prior is observed, too, and counts on both
/// sides.
void countDegreesOfFreedom(JointFit& fit, const JointProblem& problem) {
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    if (!std::isinf(problem.priorSigma(i))) continue;
    const bool ofOneArc =
        fit.unknowns[i].arc < fit.misfits.size() && fit.unknowns[i].kind != Unknown::Kind::Error;
    --(ofOneArc ? fit.misfits[fit.unknowns[i].arc].degreesOfFreedom : fit.degreesOfFreedom);
  }
  for (const ArcMisfit& misfit : fit.misfits) fit.degreesOfFreedom += misfit.degreesOfFreedom;
}

}  // namespace

std::size_t JointFit::indexOf(const Unknown& unknown) const {
  auto found = std::ranges::find(unknowns, unknown);
  if (found == unknowns.end() && unknown.kind == Unknown::Kind::Radius)
    found = std::ranges::find(unknowns, Unknown{.kind = unknown.kind, .arc = Unknown::everyArc});
  return static_cast<std::size_t>(found - unknowns.begin());
}

Circle JointFit::circleOf(std::size_t arc) const {
  const auto value = [&](Unknown::Kind kind) { return values[indexOf({.kind = kind, .arc = arc})]; };
  return {value(Unknown::Kind::CentreX), value(Unknown::Kind::CentreY), value(Unknown::Kind::Radius)};
}

JointFit fitJointly(const Measurement& measurement, const std::vector<Circle>& starts,
                    const JointFitOptions& options) {
  if (std::optional<JointFit> fit = fitJointlyFast(measurement, starts, options)) return *std::move(fit);
  return fitJointlyInGeneral(measurement, starts, options);
}

JointFit fitJointlyInGeneral(const Measurement& measurement, const std::vector<Circle>& starts,
                             const JointFitOptions& options) {
  assert(starts.size() == measurement.arcs.size());
  const JointProblem problem(measurement, options);
  const Minimum minimum = minimise(problem, problem.start(starts), options);
  const auto estimated = static_cast<Index>(problem.estimated().size());
  const auto considered = static_cast<Index>(problem.considered().size());
  const MatrixXd cofactor = inverseScaled(minimum.system.matrix.topLeftCorner(estimated, estimated));
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> perConsidered =
      -cofactor * minimum.system.matrix.topRightCorner(estimated, considered);

  JointFit fit;
  fit.unknowns = problem.estimated();
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
    fit.values.push_back(problem.priorValue(i) + minimum.state.unknowns[static_cast<Index>(i)]);
  if (measurement.radiusModel == RadiusModel::Known)
    fit.radiusPriorSigma =
        problem.priorSigma(fit.indexOf({.kind = Unknown::Kind::Radius, .arc = Unknown::everyArc}));
  fit.cofactor = plain(cofactor);
  fit.cofactorWithoutTerms = plain(withoutTerms(minimum.system.matrix, problem));
  fit.considered = problem.considered();
  for (std::size_t i = 0; i < fit.considered.size(); ++i)
    fit.consideredSigmas.push_back(problem.consideredSigma(i));
  fit.perConsidered.assign(perConsidered.data(), perConsidered.data() + perConsidered.size());
  fit.arcAngles = anglesOfSightings(measurement, problem, minimum.state);
  fit.iterations = minimum.iterations;
  fit.chiSquare = minimum.system.chiSquare;
  fit.isDetermined = std::isfinite(fit.chiSquare) && minimum.state.unknowns.allFinite() &&
                     cofactor.allFinite() && perConsidered.allFinite() &&
                     (cofactor.diagonal().array() >= 0).all();
  fit.converged = minimum.converged && fit.isDetermined;
  fit.misfits.resize(measurement.arcs.size());
  fillReadings(fit, measurement, problem, minimum.system.equations, cofactor);
  countDegreesOfFreedom(fit, problem);
  return fit;
}

}  // namespace alidade
