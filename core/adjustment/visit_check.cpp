#include "core/adjustment/visit_check.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/adjustment/joint_problem.h"
#include "core/base/statistics.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double wrappedRadians(double radians) {
  return wrapped(Angle::fromRadians(radians)).radians();
}

struct PointPlace {
  int point = 0;
  double phi = 0;  ///< rad, running on beyond ±π
};

/// The arc angle as a straight line over the point number, and how closely the places keep to it.
struct Spacing {
  double phiAtZero = 0, step = 0;  ///< rad, rad per point
  double scatter = 0;              ///< 1σ of a place, rad; 0: nothing is known of the spacing

  double logLikelihood(int point, double phi) const {
    if (scatter <= 0) return 0;
    constexpr double freedom = 3;
    const double off = wrappedRadians(phi - phiAtZero - step * point) / scatter;
    return -(freedom + 1) / 2 * std::log1p(off * off / freedom);
  }
};

/// By medians, so that a place or two may be off.
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

}  // namespace

struct VisitCheck::Content {
  Measurement probe;  ///< the measurement with one arc and no rows
  JointFitOptions options;
  Circle circle;
  std::vector<Unknown> unknowns;  ///< of the probe
  VectorXd values;
  MatrixXd cofactor;
  double variance = 1;  ///< of the noise, in stated ones
  double freedom = 0;
  Spacing spacing;

  /// Of the fit's numbers those that hold for the arc, with unknowns that the fit does not have left free.
  void takeOver(const JointFit& fit, std::size_t arc) {
    std::vector<std::size_t> indices;
    for (Unknown unknown : fit.unknowns) {
      if (!unknown.concerns(arc)) continue;
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
};

VisitCheck::VisitCheck(const Measurement& measurement, std::size_t arc,
                       const std::vector<ReadingRef>& inQuestion, const JointFit& fit,
                       const JointFitOptions& options)
    : m_content(std::make_unique<Content>()) {
  Content& content = *m_content;
  content.freedom = fit.converged ? fit.degreesOfFreedom : 0;
  if (content.freedom < 1) return;
  content.variance = std::max(fit.chiSquare / content.freedom, 1e-6);
  content.options = options;
  content.options.without.clear();
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
  JointState state = problem.start({m_content->circle});
  const auto count = static_cast<Index>(problem.estimated().size());
  MatrixXd cofactor = MatrixXd::Zero(count, count);
  std::vector<Index> indices;
  for (Index i = 0; i < count; ++i) {
    const auto found =
        std::ranges::find(m_content->unknowns, problem.estimated()[static_cast<std::size_t>(i)]);
    indices.push_back(found == m_content->unknowns.end() ? -1 : found - m_content->unknowns.begin());
    constexpr double unknownZero = 100;  // rad²: the first slider reading of an arc tells nothing
    if (indices.back() < 0)
      cofactor(i, i) = unknownZero;
    else
      state.unknowns[i] = m_content->values[indices.back()] - problem.priorValue(static_cast<std::size_t>(i));
    for (Index j = 0; j <= i; ++j)
      if (indices[static_cast<std::size_t>(i)] >= 0 && indices[static_cast<std::size_t>(j)] >= 0)
        cofactor(i, j) = cofactor(j, i) =
            m_content->cofactor(indices[static_cast<std::size_t>(i)], indices[static_cast<std::size_t>(j)]);
  }
  const VectorXd noStep = VectorXd::Zero(count);
  for (int iteration = 0; iteration < 12; ++iteration) {
    const double before = state.arcAngles[0];
    state = problem.moved(state, {problem.equationsOf(state, 0)}, noStep);
    if (std::abs(state.arcAngles[0] - before) < 1e-10) break;
  }
  const VisitEquations equations = problem.equationsOf(state, 0);
  const Index readings = equations.residual.size();
  MatrixXd reduced(readings, count);
  for (Index row = 0; row < readings; ++row)
    reduced.row(row) = problem.spread(JointProblem::reduced(equations, row), 0).head(count).transpose();
  const MatrixXd covariance =
      MatrixXd::Identity(readings, readings) + reduced * cofactor * reduced.transpose();
  const VectorXd residual = equations.residual;

  VisitAgreement agreement;
  agreement.tests = static_cast<int>(readings) - 1;
  agreement.misfit = residual.dot(covariance.ldlt().solve(residual)) / m_content->variance;
  const double freedom = m_content->freedom;
  agreement.probability = fUpperTail(agreement.misfit / agreement.tests, agreement.tests, freedom);
  agreement.logLikelihood = -(freedom + agreement.tests) / 2 * std::log1p(agreement.misfit / freedom) +
                            m_content->spacing.logLikelihood(rows.front().point, state.arcAngles[0]);
  for (Index row = 0; row < readings; ++row) {
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
