#include "core/series/history/congruence.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"

namespace alidade {

namespace {

/// Numbers with their covariance.
struct Vector {
  std::vector<std::string> ids;
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;
};

Vector lengthsOf(const Epoch& epoch) {
  const auto count = static_cast<Eigen::Index>(epoch.lengths.size());
  Vector vector{{}, Eigen::VectorXd(count), Eigen::MatrixXd(count, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto row = static_cast<std::size_t>(i);
    vector.ids.push_back(epoch.lengths[row].id);
    vector.values(i) = epoch.lengths[row].value;
    for (Eigen::Index j = 0; j < count; ++j)
      vector.covariance(i, j) = epoch.covariance(row, static_cast<std::size_t>(j));
  }
  return vector;
}

/// Returns the numbers that do not depend on the set-up of the theodolite.
Vector deviceOf(const Vector& all) {
  const auto indexOf = [&](const char* id) -> Eigen::Index {
    return std::ranges::find(all.ids, id) - all.ids.begin();
  };
  const auto count = static_cast<Eigen::Index>(all.ids.size());
  Vector own;
  std::vector<Eigen::RowVectorXd> rows;
  const auto add = [&](const char* name, std::initializer_list<std::pair<const char*, double>> parts) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(count);
    for (const auto& [id, weight] : parts) {
      if (indexOf(id) == count) return;
      row(indexOf(id)) = weight;
    }
    own.ids.emplace_back(name);
    rows.push_back(row);
  };
  add("half_difference_x", {{"o1_x", 0.5}, {"o2_x", -0.5}});
  add("half_difference_y", {{"o1_y", 0.5}, {"o2_y", -0.5}});
  add("radius_0", {{"radius_0", 1}});
  add("radius_180", {{"radius_180", 1}});
  Eigen::MatrixXd weights(static_cast<Eigen::Index>(rows.size()), count);
  for (std::size_t i = 0; i < rows.size(); ++i) weights.row(static_cast<Eigen::Index>(i)) = rows[i];
  own.values = weights * all.values;
  own.covariance = weights * all.covariance * weights.transpose();
  return own;
}

/// Degrees of freedom of a sum of covariances, by Welch and Satterthwaite from the traces.
double freedomOf(const Eigen::MatrixXd& one, double oneFreedom, const Eigen::MatrixXd& other,
                 double otherFreedom) {
  const double a = one.trace(), b = other.trace();
  const double inverse = a * a / oneFreedom + b * b / otherFreedom;
  return inverse > 0 ? (a + b) * (a + b) / inverse : std::numeric_limits<double>::infinity();
}

std::optional<CongruenceTest> test(const Vector& one, double oneFreedom, const Vector& other,
                                   double otherFreedom) {
  if (one.ids.empty() || one.ids != other.ids) return std::nullopt;
  const Eigen::VectorXd difference = other.values - one.values;
  const Eigen::MatrixXd covariance = one.covariance + other.covariance;
  const Eigen::VectorXd us = covariance.diagonal().cwiseSqrt();
  if (!us.allFinite() || !(us.minCoeff() > 0)) return std::nullopt;
  // Scaled to units of σ for a stable factorisation: centres and radii of a short arc are highly correlated.
  const Eigen::MatrixXd correlation =
      us.cwiseInverse().asDiagonal() * covariance * us.cwiseInverse().asDiagonal();
  const Eigen::LLT<Eigen::MatrixXd> factor(correlation);
  if (factor.info() != Eigen::Success) return std::nullopt;
  CongruenceTest result{
      .ids = one.ids, .differences = {difference.begin(), difference.end()}, .us = {us.begin(), us.end()}};
  result.statistic = factor.matrixL().solve(difference.cwiseQuotient(us)).squaredNorm();
  result.degreesOfFreedom = freedomOf(one.covariance, oneFreedom, other.covariance, otherFreedom);
  const auto chance =
      fUpperTail(result.statistic, static_cast<double>(one.ids.size()), result.degreesOfFreedom);
  if (!chance) return std::nullopt;
  result.chance = *chance;
  return result;
}

}  // namespace

bool haveOneInstrument(const Epoch& one, const Epoch& other) {
  return !one.instrumentSerial.empty() && one.instrumentSerial == other.instrumentSerial;
}

bool haveOneDevice(const Epoch& one, const Epoch& other) {
  return !one.deviceSerial.empty() && one.deviceSerial == other.deviceSerial;
}

double sharedVariance(const Epoch& one, const Epoch& other) {
  double sum = 0;
  for (const LastingShare& share : one.lasting) {
    const auto same = std::ranges::find(other.lasting, share.effect, &LastingShare::effect);
    const bool isShared =
        share.source == ErrorSource::Guideway ? haveOneDevice(one, other) : haveOneInstrument(one, other);
    if (same != other.lasting.end() && isShared) sum += share.sigma * same->sigma;
  }
  return sum;
}

Congruence congruenceOf(const std::vector<Epoch>& epochs, std::size_t first, std::size_t second) {
  const Epoch &one = epochs[first], &other = epochs[second];
  Congruence congruence{.first = first, .second = second};
  congruence.difference = other.intersection.value - one.intersection.value;
  const double a = std::pow(one.intersection.sigma, 2), b = std::pow(other.intersection.sigma, 2);
  congruence.u = standardDeviation(a + b - 2 * sharedVariance(one, other));
  const double inverse =
      a * a / one.intersection.degreesOfFreedom + b * b / other.intersection.degreesOfFreedom;
  const double freedom =
      inverse > 0 ? std::pow(congruence.u, 4) / inverse : std::numeric_limits<double>::infinity();
  // Shared effects that cancel must not reduce the degrees of freedom: their size has no sampling error.
  const double counted =
      std::max(freedom, std::min(one.intersection.degreesOfFreedom, other.intersection.degreesOfFreedom));
  congruence.expanded = coverageFactor(std::max(one.coverage, other.coverage), counted) * congruence.u;
  const auto tail = studentLowerTail(-std::abs(congruence.difference) / congruence.u, counted);
  congruence.chance = tail ? 2 * *tail : 1;
  congruence.hasChanged = std::abs(congruence.difference) > congruence.expanded;
  const Vector before = lengthsOf(one), after = lengthsOf(other);
  congruence.setUp = test(before, one.degreesOfFreedom, after, other.degreesOfFreedom);
  congruence.device = test(deviceOf(before), one.degreesOfFreedom, deviceOf(after), other.degreesOfFreedom);
  return congruence;
}

}  // namespace alidade
