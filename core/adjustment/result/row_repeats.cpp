#include "core/adjustment/result/row_repeats.h"

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <numbers>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/base/angle.h"
#include "core/base/statistics.h"

namespace alidade {

namespace {

constexpr double tooSeldom = 0.01;
constexpr double nearSteps = 10;  // of the grid, to either side

/// The circle readings that two identical rows share: face, a and e in rad.
using Circles = std::tuple<int, double, double>;

/// Face and point number of a row. Rows that share both sight the same place in the same face.
using Mark = std::pair<int, int>;

/// The first index of each key.
template <typename Key>
using FirstIndices = std::unordered_map<Key, std::size_t, boost::hash<Key>>;

Mark markOf(const Sighting& row) {
  return {row.face, row.point};
}

using IndexPair = std::pair<std::size_t, std::size_t>;

/// Pairs of sightings with the same readings: the first of a group and each further one, in order.
std::vector<IndexPair> alikeIn(const ArcMeasurement& arc) {
  FirstIndices<Circles> firsts;
  std::vector<IndexPair> alike;
  for (std::size_t i = 0; i < arc.sightings.size(); ++i) {
    const Sighting& row = arc.sightings[i];
    constexpr double noMinus = 0;  // makes 0 of −0
    const Circles circles{row.face, row.a.radians() + noMinus, row.e.radians() + noMinus};
    const std::size_t first = firsts.try_emplace(circles, i).first->second;
    if (first != i) alike.emplace_back(first, i);
  }
  return alike;
}

double gridOf(const ArcMeasurement& arc, Angle Sighting::*circle) {
  std::vector<double> read;
  read.reserve(arc.sightings.size());
  for (const Sighting& row : arc.sightings) read.push_back((row.*circle).radians());
  return alidade::gridOf(read);
}

/// Is it improbable to find this many events (≥ 1) or more if `expected` are expected?
bool isTooMany(std::size_t events, double expected) {
  const auto fewer = chiSquareUpperTail(2 * expected, 2 * static_cast<double>(events));  // for Poisson counts
  return fewer && 1 - *fewer < tooSeldom;
}

/// The number of pairs of rows at one place.
double pairsOfOnePlace(const ArcMeasurement& arc) {
  FirstIndices<Mark> firsts;
  std::vector<std::size_t> counts(arc.sightings.size());
  double pairs = 0;
  for (std::size_t i = 0; i < arc.sightings.size(); ++i)
    pairs += static_cast<double>(counts[firsts.try_emplace(markOf(arc.sightings[i]), i).first->second]++);
  return pairs;
}

/// The number of pairs of rows in one face, at different places, whose readings are unequal but differ by at
/// most a few steps of the grid.
double nearPairsOfTwoPlaces(const ArcMeasurement& arc, double gridA, double gridE) {
  constexpr double reach = nearSteps + 0.5;
  struct Row {
    double a, e;
    Mark mark;
  };
  std::vector<Row> rows;
  rows.reserve(arc.sightings.size());
  for (const Sighting& row : arc.sightings) rows.push_back({row.a.radians(), row.e.radians(), markOf(row)});
  std::ranges::sort(rows, {}, &Row::a);
  double pairs = 0;
  for (auto one = rows.begin(); one != rows.end(); ++one)
    for (auto other = one + 1; other != rows.end() && other->a - one->a < reach * gridA; ++other) {
      const bool isNear =
          std::abs(other->e - one->e) < reach * gridE && (other->a != one->a || other->e != one->e);
      if (isNear && one->mark.first == other->mark.first && one->mark.second != other->mark.second) ++pairs;
    }
  return pairs;
}

}  // namespace

double gridOf(const std::vector<double>& read) {
  constexpr std::array arcseconds{60.0, 30.0,   20.0, 10.0,  5.0,   3.24,    2.0,   1.62,
                                  1.0,  0.648,  0.5,  0.324, 0.2,   0.162,   0.1,   0.0648,
                                  0.05, 0.0324, 0.02, 0.01,  0.005, 0.00324, 0.002, 0.001};
  const auto isOn = [&](double grid) {
    return std::ranges::all_of(read, [&](double angle) {
      const double steps = (angle - read.front()) / grid;
      return std::abs(steps - std::round(steps)) < 1e-3;
    });
  };
  for (const double seconds : arcseconds)
    if (const double grid = Angle::fromArcseconds(seconds).radians(); isOn(grid)) return grid;
  return 0;
}

/// The difference D of two readings before rounding is normal. For a uniform position on the grid, both are
/// rounded to the same value with probability E max(0, 1 − |D|/grid).
double chanceOfBeingAlike(double grid, double scatter) {
  if (!(grid > 0)) return 0;
  const double t = grid / (std::numbers::sqrt2 * scatter);
  if (!(t < 1e8)) return 1;
  const double within = std::erf(t / std::numbers::sqrt2);
  const double lost = std::sqrt(2 / std::numbers::pi) / t * -std::expm1(-t * t / 2);
  return std::max(0.0, within - lost);
}

std::vector<std::pair<std::size_t, std::size_t>> repeatedRows(const Measurement& measurement,
                                                              const ArcMeasurement& arc, const ArcFit& fit) {
  const std::vector<IndexPair> alike = alikeIn(arc);
  if (alike.empty()) return {};
  const auto isOfOnePlace = [&](const IndexPair& pair) {
    return markOf(arc.sightings[pair.first]) == markOf(arc.sightings[pair.second]);
  };
  const auto ofOnePlace = static_cast<std::size_t>(std::ranges::count_if(alike, isOfOnePlace));
  const std::size_t ofTwo = alike.size() - ofOnePlace;
  const double gridA = gridOf(arc, &Sighting::a), gridE = gridOf(arc, &Sighting::e);
  // Readings may scatter less than stated, and are then equal more often.
  const double ratio = fit.degreesOfFreedom > 0 ? std::min(1.0, std::sqrt(fit.reducedChiSquare())) : 1;
  const double chance = chanceOfBeingAlike(gridA, ratio * measurement.sigmaHorizontal.radians()) *
                        chanceOfBeingAlike(gridE, ratio * measurement.sigmaVertical.radians());
  const bool isOfOneSignificant = ofOnePlace > 0 && isTooMany(ofOnePlace, chance * pairsOfOnePlace(arc));
  // Probability that rows of two nearby places are equal; the two may be one place with two numbers.
  const double share = std::max(chance, 1 / ((2 * nearSteps + 1) * (2 * nearSteps + 1)));
  const bool isOfTwoSignificant =
      ofTwo > 0 && isTooMany(ofTwo, nearPairsOfTwoPlaces(arc, gridA, gridE) * share / (1 - share));
  std::vector<IndexPair> repeated;
  for (const IndexPair& pair : alike)
    if (isOfOnePlace(pair) ? isOfOneSignificant : isOfTwoSignificant)
      repeated.emplace_back(arc.sightings[pair.first].row, arc.sightings[pair.second].row);
  return repeated;
}

}  // namespace alidade
