#include "core/adjustment/gross_errors/visit_check.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/adjustment/joint/joint_problem.h"
#include "core/base/statistics.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

double wrappedRadians(double radians) {
  return wrapped(Angle::fromRadians(radians)).radians();
}

struct PointPlace {
  int point = 0;
  double phi = 0;  ///< rad, continued beyond ±π
};

/// The arc angle as a linear function of the point number, and the scatter of the places about it.
struct Spacing {
  double phiAtZero = 0, step = 0;  ///< rad, rad per point
  double scatter = 0;              ///< 1σ of a place, rad; 0: the spacing is unknown

  double off(int point, double phi) const {
    return scatter > 0 ? std::abs(wrappedRadians(phi - phiAtZero - step * point)) / scatter : 0;
  }

  double logLikelihood(int point, double phi) const {
    constexpr double freedom = 3;
    const double off = this->off(point, phi);
    return -(freedom + 1) / 2 * std::log1p(off * off / freedom);
  }
};

/// Uses medians, so that a few places may deviate.
Spacing spacingOf(std::vector<PointPlace> places) {
  constexpr std::size_t fewest = 6, most = 60;
  std::ranges::sort(places, {}, &PointPlace::point);
  for (std::size_t i = 1; i < places.size(); ++i)
    places[i].phi = places[i - 1].phi + wrappedRadians(places[i].phi - places[i - 1].phi);
  if (places.size() > most) {
    std::vector<PointPlace> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(places[i * places.size() / most]);
    places = std::move(some);
  }
  if (places.size() < fewest) return {};
  std::vector<double> steps, offsets, sizes;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j)
      if (places[i].point != places[j].point)
        steps.push_back((places[j].phi - places[i].phi) / (places[j].point - places[i].point));
  if (steps.empty()) return {};
  Spacing spacing;
  spacing.step = medianOf(steps);
  for (const PointPlace& place : places) offsets.push_back(place.phi - spacing.step * place.point);
  spacing.phiAtZero = medianOf(offsets);
  for (const double offset : offsets) sizes.push_back(std::abs(offset - spacing.phiAtZero));
  const auto count = static_cast<double>(places.size());
  constexpr double least = 1e-6;  // rad; a fraction of a second
  spacing.scatter = std::max(least, 1.4826 * (1 + 5 / count) * medianOf(sizes));
  return spacing;
}

/// The fit's prediction of a probe's unknowns, with its covariance.
struct Prediction {
  JointState state;
  MatrixXd cofactor;
};

/// Adjusts the arc angle of the only visit, with the unknowns fixed.
JointState withArcAngleAdjusted(const JointProblem& problem, JointState state) {
  const VectorXd noStep = VectorXd::Zero(static_cast<Index>(problem.estimated().size()));
  for (int iteration = 0; iteration < 12; ++iteration) {
    const double before = state.arcAngles[0];
    state = problem.moved(state, {problem.equationsOf(state, 0)}, noStep);
    if (std::abs(state.arcAngles[0] - before) < 1e-10) break;
  }
  return state;
}

/// Covariance of the whitened residuals: their own noise plus that of the prediction.
MatrixXd covarianceOf(const JointProblem& problem, const VisitEquations& equations,
                      const MatrixXd& cofactor) {
  const Index readings = equations.residual.size(), count = cofactor.rows();
  MatrixXd reduced(readings, count);
  for (Index row = 0; row < readings; ++row)
    reduced.row(row) = problem.spread(JointProblem::reduced(equations, row), 0).head(count).transpose();
  return MatrixXd::Identity(readings, readings) + reduced * cofactor * reduced.transpose();
}

}  // namespace

struct VisitCheck::Content {
  Measurement probe;  ///< the measurement with one arc and no rows
  JointFitOptions options;
  Circle circle;
  std::vector<Unknown> unknowns;  ///< of the probe
  VectorXd values;
  MatrixXd cofactor;
  double variance = 1;  ///< of the noise, in units of the stated variance
  double freedom = 0;
  Spacing spacing;

  /// Takes over the fit's values for the arc. Unknowns missing in the fit stay free.
  void takeOver(const JointFit& fit, std::size_t arc) {
    std::vector<std::size_t> indices;
    for (Unknown unknown : fit.unknowns) {
      if (!unknown.concerns(arc, fit.firsts)) continue;
      indices.push_back(fit.indexOf(unknown));
      if (unknown.arc != Unknown::everyArc) unknown.arc = 0;
      unknowns.push_back(unknown);
    }
    const auto count = static_cast<Index>(indices.size());
    values.resize(count);
    cofactor.resize(count, count);
    for (Index i = 0; i < count; ++i) {
      values[i] = fit.values[indices[static_cast<std::size_t>(i)]];
      for (Index j = 0; j < count; ++j)
        cofactor(i, j) =
            fit.cofactor(indices[static_cast<std::size_t>(i)], indices[static_cast<std::size_t>(j)]);
    }
  }

  /// Index among `unknowns`; −1 if the fit lacks it.
  Index indexOf(const Unknown& unknown) const {
    const auto found = std::ranges::find(unknowns, unknown);
    return found == unknowns.end() ? -1 : found - unknowns.begin();
  }

  Prediction predictionFor(const JointProblem& problem) const {
    constexpr double unknownZero = 100;  // rad²: an arc's first slider reading only gives its zero
    const auto count = static_cast<Index>(problem.estimated().size());
    Prediction prediction{problem.start({circle}), MatrixXd::Zero(count, count)};
    std::vector<Index> indices;
    for (const Unknown& unknown : problem.estimated()) indices.push_back(indexOf(unknown));
    for (Index i = 0; i < count; ++i) {
      const Index own = indices[static_cast<std::size_t>(i)];
      if (own < 0) {
        prediction.cofactor(i, i) = unknownZero;
        continue;
      }
      prediction.state.unknowns[i] = values[own] - problem.prior(static_cast<std::size_t>(i)).value;
      for (Index j = 0; j <= i; ++j)
        if (const Index other = indices[static_cast<std::size_t>(j)]; other >= 0)
          prediction.cofactor(i, j) = prediction.cofactor(j, i) = cofactor(own, other);
    }
    return prediction;
  }
};

VisitCheck::VisitCheck(const Measurement& measurement, std::size_t arc,
                       const std::vector<ReadingRef>& inQuestion, const JointFit& fit,
                       const JointFitOptions& options)
    : m_content(std::make_unique<Content>()) {
  Content& content = *m_content;
  content.freedom = fit.converged() ? fit.degreesOfFreedom : 0;
  if (content.freedom < 1) return;
  content.variance = std::max(fit.chiSquare / content.freedom, 1e-6);
  content.options = options;
  content.options.without.clear();
  content.options.estimatesZeros = hasRepeats(measurement);
  content.takeOver(fit, arc);
  const auto value = [&](Unknown::Kind kind) { return fit.values[fit.indexOf({.kind = kind, .arc = arc})]; };
  content.circle = {value(Unknown::Kind::CentreX), value(Unknown::Kind::CentreY),
                    value(Unknown::Kind::Radius)};
  std::vector<PointPlace> places;
  const auto& sightings = measurement.arcs[arc].sightings;
  for (std::size_t i = 0; i < sightings.size(); ++i)
    if (std::ranges::find(inQuestion, ReadingRef{arc, i, ReadingKind::Horizontal}) == inQuestion.end())
      places.push_back({sightings[i].point, fit.arcAngles[arc][i]});
  content.spacing = spacingOf(std::move(places));
  content.probe = measurement;
  content.probe.arcs = {measurement.arcs[arc]};
  content.probe.arcs[0].sightings.clear();
}

VisitCheck::~VisitCheck() = default;
VisitCheck::VisitCheck(VisitCheck&&) noexcept = default;
VisitCheck& VisitCheck::operator=(VisitCheck&&) noexcept = default;

bool VisitCheck::canCheck() const {
  return m_content->freedom >= 1;
}

VisitAgreement VisitCheck::agreement(const std::vector<Sighting>& rows) const {
  Measurement probe = m_content->probe;
  probe.arcs[0].sightings = rows;
  const JointProblem problem(probe, m_content->options);
  const Prediction prediction = m_content->predictionFor(problem);
  const JointState state = withArcAngleAdjusted(problem, prediction.state);
  const VisitEquations equations = problem.equationsOf(state, 0);
  const VectorXd residual = equations.residual;

  VisitAgreement agreement;
  agreement.tests = static_cast<int>(residual.size()) - 1;
  const double freedom = m_content->freedom;
  const Eigen::LDLT<MatrixXd> factor(covarianceOf(problem, equations, prediction.cofactor));
  const WeightedSquareSum squares = factor.isPositive()
                                        ? residual.dot(factor.solve(residual)) / m_content->variance
                                        : std::numeric_limits<double>::quiet_NaN();
  agreement.offSpacing = m_content->spacing.off(rows.front().point, state.arcAngles[0]);
  if (const auto tail = fUpperTail(squares, agreement.tests, freedom)) {
    agreement.probability = *tail;
    agreement.logLikelihood = -(freedom + agreement.tests) / 2 * std::log1p(squares.value() / freedom) +
                              m_content->spacing.logLikelihood(rows.front().point, state.arcAngles[0]);
  }
  for (Index row = 0; row < residual.size(); ++row) {
    const std::size_t pair = static_cast<std::size_t>(row) / 2;
    const Angle sigma = pair >= rows.size() ? probe.sigmaSlider
                        : row % 2 == 0      ? probe.sigmaHorizontal
                                            : probe.sigmaVertical;
    agreement.residuals.push_back(residual[row] * sigma.radians());
  }
  return agreement;
}

std::vector<ReadingRef> readingsOf(const Measurement& measurement, std::size_t arc, int round, int point) {
  std::vector<ReadingRef> readings;
  const auto& sightings = measurement.arcs[arc].sightings;
  for (std::size_t i = 0; i < sightings.size(); ++i)
    if (sightings[i].round == round && sightings[i].point == point)
      for (const auto kind : {ReadingKind::Horizontal, ReadingKind::Vertical, ReadingKind::Slider})
        readings.push_back({arc, i, kind});
  return readings;
}

}  // namespace alidade
