#include "core/adjustment/joint/joint_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/adjustment/joint/fast_joint_fit.h"
#include "core/adjustment/joint/joint_problem.h"
#include "core/adjustment/joint/sighted_zeros.h"
#include "core/adjustment/numerics/least_squares.h"
#include "core/base/statistics.h"
#include "core/observation/half_turn.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Scales the matrix to a unit diagonal before factoring it: millimetres and radians differ by 1e6 in size.
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

/// The `Problem` of `minimise`.
class JointDescent {
 public:
  using State = JointState;
  using System = JointSystem;

  explicit JointDescent(const JointProblem& problem)
      : m_problem(problem), m_estimated(static_cast<Index>(problem.estimated().size())) {}

  JointSystem system(const JointState& state, JointSystem used) const {
    return m_problem.system(state, std::move(used));
  }

  double remaining(const JointSystem& system) const {
    const VectorXd rightSide = system.rightSide.head(m_estimated);
    const double squared =
        rightSide.dot(solveScaled(system.matrix.topLeftCorner(m_estimated, m_estimated), rightSide));
    return squared >= 0 ? std::sqrt(squared) : std::numeric_limits<double>::infinity();
  }

  JointState moved(const JointState& state, const JointSystem& system, double damping) const {
    MatrixXd damped = system.matrix.topLeftCorner(m_estimated, m_estimated);
    damped.diagonal() *= 1 + damping;
    return m_problem.moved(state, system.equations, solveScaled(damped, system.rightSide.head(m_estimated)));
  }

  /// True if all radii are positive: a negative radius gives the same circle with arc angles half a turn off.
  bool isPossible(const JointState& state) const {
    for (std::size_t i = 0; i < m_problem.estimated().size(); ++i)
      if (m_problem.estimated()[i].kind == Unknown::Kind::Radius &&
          !(m_problem.prior(i).value + state.unknowns[static_cast<Index>(i)] > 0))
        return false;
    return true;
  }

 private:
  const JointProblem& m_problem;
  Index m_estimated;
};

SquareMatrix plain(const MatrixXd& matrix) {
  SquareMatrix result{static_cast<std::size_t>(matrix.rows()), {}};
  for (Index i = 0; i < matrix.rows(); ++i)
    for (Index j = 0; j < matrix.cols(); ++j) result.values.push_back((matrix(i, j) + matrix(j, i)) / 2);
  return result;
}

/// ∂Δd/∂unknowns: half the difference of the heights of the centres at 0° and 180°.
VectorXd intersectionGradient(const Measurement& measurement, const std::vector<Unknown>& unknowns) {
  VectorXd gradient = VectorXd::Zero(static_cast<Index>(unknowns.size()));
  if (!hasBothAxes(measurement)) return gradient;
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    if (unknowns[i].kind == Unknown::Kind::CentreY)
      gradient[static_cast<Index>(i)] = intersectionPerHeight(measurement.arcs[unknowns[i].arc].axisDeg);
  return gradient;
}

/// The inverse of the normal matrix without error terms. The error terms are the last estimated unknowns;
/// their entries are zero.
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
    const auto& [arc, visit, slider] = problem.visits()[v];
    double phi = state.arcAngles[static_cast<Index>(v)];
    if (!slider) phi = unwrappedArcAngle(phi, measurement.arcs[arc].axisDeg);
    for (const std::size_t i : visit.sightings) angles[arc][i] = phi;
  }
  return angles;
}

bool isOfZero(const Measurement& measurement, const ReadingRef& cell) {
  return cell.kind != ReadingKind::Slider && measurement.arcs[cell.arc].sightings[cell.sighting].isZero;
}

std::vector<double> spreadOf(const JointProblem& problem, const Slots& row, std::size_t arc,
                             std::size_t unknowns) {
  const VectorXd all = problem.spread(row, arc);
  return {all.data(), all.data() + static_cast<Index>(unknowns)};
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
  std::size_t readings = 0;
  for (const VisitEquations& equations : all) readings += static_cast<std::size_t>(equations.residual.size());
  fit.readings.reserve(readings);
  for (std::size_t v = 0, first = 0; v < problem.visits().size(); ++v) {
    const VisitEquations& equations = all[v];
    const std::size_t arc = problem.visits()[v].arc;
    if (arc != problem.visits()[first].arc) first = v;
    ArcResidualSum& sum = fit.residualSums[arc];
    sum.chiSquare += equations.residual.squaredNorm();
    const VisitEquations::Jacobian columns = JointProblem::reduced(equations);
    fit.degreesOfFreedom -= equations.along.isZero(0) ? 0 : 1;
    for (Index row = 0; row < equations.residual.size(); ++row) {
      const Slots reduced = columns.row(row).transpose();
      const Slots turned = cofactors[arc].lazyProduct(reduced);
      const ReadingRef cell = problem.cellOf(v, row);
      AdjustedReading reading{.arc = cell.arc,
                              .sighting = cell.sighting,
                              .kind = cell.kind,
                              .visit = static_cast<std::uint32_t>(v - first)};
      reading.sigma = sigmaOf(measurement, cell).radians();
      reading.residual = equations.residual[row] * reading.sigma;
      const bool takesPart = !equations.jacobian.row(row).isZero(0);
      fit.degreesOfFreedom += takesPart ? 1 : 0;
      reading.redundancy = std::clamp(
          (takesPart ? 1 : 0) - equations.along[row] * equations.along[row] - reduced.dot(turned), 0.0, 1.0);
      sum.degreesOfFreedom += reading.redundancy;
      reading.perReading = gradients[arc].dot(reduced) / reading.sigma;
      if (isOfZero(measurement, cell))
        fit.zeroRows.push_back(spreadOf(problem, reduced, arc, fit.unknowns.size()));
      fit.readings.push_back(reading);
    }
  }
  for (ArcResidualSum& sum : fit.residualSums) sum.degreesOfFreedom = redundancyOf(sum.degreesOfFreedom);
  // Observations in χ² minus estimated unknowns. An unknown with a prior is also an observation and counts on
  // both sides.
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
    fit.degreesOfFreedom -= problem.prior(i).isInformative() ? 0 : 1;
}

/// Did the fit diverge from every circle? The stated noise alone makes a centre or radius uncertain by more
/// than the smallest radius.
bool hasRunAway(const JointFit& fit) {
  double radius = std::numeric_limits<double>::infinity(), sigma = 0;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    if (fit.unknowns[i].isOfAxis()) sigma = std::max(sigma, std::sqrt(fit.cofactor(i, i)));
    if (fit.unknowns[i].kind == Unknown::Kind::Radius) radius = std::min(radius, fit.values[i]);
  }
  return sigma > radius;
}

}  // namespace

std::size_t JointFit::indexOf(const Unknown& unknown) const {
  Unknown requested = unknown;
  if (requested.isOfAxis() && requested.arc < firsts.size()) requested.arc = firsts[requested.arc];
  auto found = std::ranges::find(unknowns, requested);
  if (found == unknowns.end() && requested.isOfAxis() && requested.kind != Unknown::Kind::CentreY)
    found = std::ranges::find(unknowns, Unknown{.kind = requested.kind, .arc = Unknown::everyArc});
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
  const auto minimum = minimise(JointDescent(problem), problem.start(starts),
                                {.maximumIterations = options.maximumIterations,
                                 .tolerance = options.tolerance,
                                 .confirmation = 1e-4,  // arc angles follow by their linear equations
                                 .firstDamping = 1e-9,
                                 .largestDamping = 1e9});
  const auto estimated = static_cast<Index>(problem.estimated().size());
  const auto considered = static_cast<Index>(problem.considered().size());
  const MatrixXd cofactor = inverseScaled(minimum.system.matrix.topLeftCorner(estimated, estimated));
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> perConsidered =
      -cofactor * minimum.system.matrix.topRightCorner(estimated, considered);

  JointFit fit;
  fit.unknowns = problem.estimated();
  fit.firsts = problem.firsts();
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
    fit.values.push_back(problem.prior(i).value + minimum.state.unknowns[static_cast<Index>(i)]);
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) fit.priorSigmas.push_back(problem.prior(i).sigma);
  fit.cofactor = plain(cofactor);
  fit.cofactorWithoutTerms = plain(withoutTerms(minimum.system.matrix, problem));
  fit.zerosAreReadings = measurement.zerosAreReadings;
  fit.zeroScatter = measurement.zeroScatter;
  fit.considered = problem.considered();
  for (std::size_t i = 0; i < fit.considered.size(); ++i)
    fit.consideredSigmas.push_back(problem.consideredSigma(i));
  fit.perConsidered.assign(perConsidered.data(), perConsidered.data() + perConsidered.size());
  fit.arcAngles = anglesOfSightings(measurement, problem, minimum.state);
  fit.iterations = minimum.iterations;
  fit.chiSquare = minimum.system.chiSquare;
  const bool isDetermined = std::isfinite(fit.chiSquare) && minimum.state.unknowns.allFinite() &&
                            cofactor.allFinite() && perConsidered.allFinite() &&
                            (cofactor.diagonal().array() >= 0).all();
  fit.status = isDetermined ? minimum.status : FitStatus::Undetermined;
  if (!fit.converged() && hasRunAway(fit)) fit.status = FitStatus::Undetermined;
  fit.residualSums.resize(measurement.arcs.size());
  fillReadings(fit, measurement, problem, minimum.system.equations, cofactor);
  return fit;
}

}  // namespace alidade
