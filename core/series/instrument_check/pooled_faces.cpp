#include "core/series/instrument_check/pooled_faces.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/square.h"
#include "core/base/statistics.h"

namespace alidade {

namespace {

constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();

/// One or two numbers of a station, with their cofactors and the variance that scales the cofactors.
struct StationNumbers {
  Eigen::VectorXd values;
  Eigen::MatrixXd cofactors;
  double variance, degreesOfFreedom;  ///< the variance is NaN without degrees of freedom
};

/// Least squares of the numbers over all stations.
struct NumbersTogether {
  Eigen::VectorXd values;
  Eigen::MatrixXd cofactors;
  double variance = notKnown, degreesOfFreedom = 0;  ///< pooled, within stations
  double widening = 1;  ///< factor of u, ≥ 1: √F of the differences between stations
  double differP = notKnown;

  double u(Eigen::Index k) const { return widening * std::sqrt(variance * cofactors(k, k)); }
  PairMean mean(Eigen::Index k) const {
    return {values(k), u(k), widening * std::sqrt(variance), degreesOfFreedom, cofactors(k, k)};
  }
};

std::optional<NumbersTogether> putTogether(const std::vector<StationNumbers>& stations) {
  if (stations.empty()) return std::nullopt;
  const Eigen::Index size = stations.front().values.size();
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd weighted = Eigen::VectorXd::Zero(size);
  NumbersTogether all;
  double squares = 0;
  for (const StationNumbers& station : stations) {
    const Eigen::MatrixXd weight = station.cofactors.inverse();
    weights += weight;
    weighted += weight * station.values;
    all.degreesOfFreedom += station.degreesOfFreedom;
    if (station.degreesOfFreedom > 0) squares += station.degreesOfFreedom * station.variance;
  }
  all.cofactors = weights.inverse();
  all.values = all.cofactors * weighted;
  if (all.degreesOfFreedom > 0) all.variance = squares / all.degreesOfFreedom;
  if (stations.size() == 1 || !(all.variance > square(roundingArcsec))) return all;
  double between = 0;
  for (const StationNumbers& station : stations) {
    const Eigen::VectorXd off = station.values - all.values;
    between += off.dot(station.cofactors.inverse() * off);
  }
  const auto conditions = static_cast<double>(size) * (static_cast<double>(stations.size()) - 1);
  all.differP = fUpperTail(between / all.variance, conditions, all.degreesOfFreedom).value_or(notKnown);
  all.widening = std::sqrt(std::max(1.0, between / conditions / all.variance));
  return all;
}

Eigen::Matrix2d cofactorsOf(const TwoCauses& causes) {
  Eigen::Matrix2d cofactors;
  cofactors << causes.cofactorCollimation, causes.cofactorBoth, causes.cofactorBoth, causes.cofactorOther;
  return cofactors;
}

StationNumbers numbersOf(const PairMean& mean) {
  return {Eigen::VectorXd::Constant(1, mean.value), Eigen::MatrixXd::Constant(1, 1, mean.cofactor),
          square(mean.scatter), mean.degreesOfFreedom};
}

Pooled pooledOf(const std::vector<const StationCheck*>& stations, PairMean StationCheck::*of) {
  std::vector<StationNumbers> numbers;
  for (const StationCheck* const station : stations)
    if (station->pairs() > 0 && (station->*of).cofactor > 0) numbers.push_back(numbersOf(station->*of));
  const auto all = putTogether(numbers);
  if (!all) return {{notKnown, notKnown, notKnown, 0}, notKnown};
  return {all->mean(0), all->differP};
}

/// The stations among `all` that state the cause; all of them if none does.
std::vector<const StationCheck*> withCause(std::vector<const StationCheck*> all,
                                           std::optional<TwoCauses> FaceCauses::*cause) {
  const auto states = [&](const StationCheck* station) { return (station->causes.*cause).has_value(); };
  if (std::ranges::any_of(all, states)) std::erase_if(all, std::not_fn(states));
  return all;
}

std::vector<const StationCheck*> each(const std::vector<StationCheck>& stations) {
  std::vector<const StationCheck*> all;
  for (const StationCheck& station : stations) all.push_back(&station);
  return all;
}

}  // namespace

Pooled pooledIndex(const std::vector<StationCheck>& stations) {
  return pooledOf(each(stations), &StationCheck::index);
}

PooledSight pooledSight(const std::vector<StationCheck>& stations) {
  const auto counting = withCause(withCause(each(stations), &FaceCauses::lineOfSight), &FaceCauses::tilt);
  std::vector<StationNumbers> numbers;
  for (const StationCheck* const station : counting) {
    if (!station->causes.lineOfSight) continue;
    const TwoCauses& sight = *station->causes.lineOfSight;
    const PairMean& collimation = station->collimation;
    numbers.push_back({Eigen::Vector2d(collimation.value, sight.other), cofactorsOf(sight),
                       square(collimation.scatter), collimation.degreesOfFreedom});
  }
  const auto all = putTogether(numbers);
  if (!all) return {pooledOf(counting, &StationCheck::collimation), std::nullopt};
  const Eigen::MatrixXd& q = all->cofactors;
  TwoCauses sight{.collimation = all->values(0),
                  .uCollimation = all->u(0),
                  .other = all->values(1),
                  .uOther = all->u(1),
                  .correlation = q(0, 1) / std::sqrt(q(0, 0) * q(1, 1)),
                  .degreesOfFreedom = all->degreesOfFreedom,
                  .pValue = twoSidedStudent(all->values(1), all->u(1), all->degreesOfFreedom)};
  return {{all->mean(0), all->differP}, sight};
}

std::optional<PairMean> pooledTilt(const std::vector<StationCheck>& stations) {
  double weights = 0, sum = 0, chiSquare = 0, count = 0, degreesOfFreedom = 0;
  const auto forEachTilt = [&](const auto& use) {
    for (const StationCheck& station : stations)
      if (const auto& tilt = station.causes.tilt; tilt && tilt->uOther > 0) use(*tilt);
  };
  forEachTilt([&](const TwoCauses& tilt) {
    weights += 1 / square(tilt.uOther);
    sum += tilt.other / square(tilt.uOther);
    degreesOfFreedom += tilt.degreesOfFreedom;
    ++count;
  });
  if (count == 0) return std::nullopt;
  const double mean = sum / weights;
  forEachTilt([&](const TwoCauses& tilt) { chiSquare += square((tilt.other - mean) / tilt.uOther); });
  const double widening = count > 1 ? std::sqrt(std::max(1.0, chiSquare / (count - 1))) : 1;
  const double u = widening / std::sqrt(weights);
  return PairMean{mean, u, u, degreesOfFreedom, 1};
}

}  // namespace alidade
