#include "core/series/instrument_check/station_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/square.h"
#include "core/base/statistics.h"

namespace alidade {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

PairMean meanOf(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  if (values.empty()) return {unknown, unknown, unknown, 0};
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  for (const double value : values) squares += square(value - mean);
  if (values.size() == 1) return {mean, unknown, unknown, 0, 1};
  const double scatter = std::sqrt(squares / (count - 1));
  return {mean, scatter / std::sqrt(count), scatter, count - 1, 1 / count};
}

std::optional<RoundTrend> slopeOf(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  constexpr std::size_t fewest = 3;
  if (values.size() < fewest ||
      std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); }))
    return std::nullopt;
  const double centre = (count - 1) / 2, mean = meanOf(values).value;
  double across = 0, along = 0, left = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    along += square(static_cast<double>(i) - centre);
    across += (static_cast<double>(i) - centre) * (values[i] - mean);
  }
  const double slope = across / along;
  for (std::size_t i = 0; i < values.size(); ++i)
    left += square(values[i] - mean - slope * (static_cast<double>(i) - centre));
  const double degreesOfFreedom = count - 2, u = std::sqrt(left / degreesOfFreedom / along);
  return RoundTrend{slope, u, degreesOfFreedom, twoSidedStudent(slope, u, degreesOfFreedom)};
}

/// Evaluates the complete rounds of a station; residuals in arcseconds.
class StationEvaluation {
 public:
  explicit StationEvaluation(const StationRounds& station) : m_station(station) {
    m_check.station = station.station;
    m_check.circles = station.circles;
    m_check.targets = station.targets.size();
    m_check.rounds = station.rounds.size();
    m_check.leftOut = station.leftOut;
    m_check.parted = station.parted;
    if (m_check.pairs() == 0) m_check.targets = m_check.rounds = 0;
  }

  StationCheck evaluate() {
    if (m_check.pairs() > 0) {
      evaluateDirections();
      evaluateVerticals();
    }
    evaluateFaces();
    if (m_check.pairs() > 0) {
      compareTargets();
      followRounds();
      separateCauses();
    }
    if (m_check.circles == CheckCircles::VerticalOnly) forgetDirections();
    if (m_check.circles == CheckCircles::HorizontalOnly) forgetVerticals();
    return std::move(m_check);
  }

 private:
  /// Clears the results of a circle that was not read.
  void forgetDirections() {
    m_check.direction = {};
    m_check.collimation = meanOf({});
    m_check.causes = {};
    m_check.collimationSlope = m_check.orientationSlope = std::nullopt;
    m_check.targetsDifferP = unknown;
    m_check.isCircleReset = false;
    for (RoundCourse& round : m_check.course) round.collimation = round.orientation = unknown;
    for (TargetMean& target : m_check.perTarget) target.collimation = unknown;
    for (PairResidual& residual : m_check.residuals) residual.direction = unknown;
  }
  void forgetVerticals() {
    m_check.vertical = {};
    m_check.index = meanOf({});
    m_check.indexSlope = std::nullopt;
    for (RoundCourse& round : m_check.course) round.index = unknown;
    for (TargetMean& target : m_check.perTarget) target.index = target.elevationDeg = unknown;
    for (PairResidual& residual : m_check.residuals) residual.vertical = unknown;
  }

  const FacePair& pair(std::size_t round, std::size_t target) const {
    return m_station.rounds[round].pairs[target];
  }
  std::size_t targets() const { return m_check.targets; }
  std::size_t rounds() const { return m_check.rounds; }

  /// Replaces each value by the mean of its target over the rounds minus the value. If `ofRoundsToo`, then
  /// subtracts the mean of each round over the targets.
  void takeOffMeans(std::vector<double>& rows, bool ofRoundsToo) const {
    for (std::size_t k = 0; k < targets(); ++k) {
      double sum = 0;
      for (std::size_t j = 0; j < rounds(); ++j) sum += rows[j * targets() + k];
      for (std::size_t j = 0; j < rounds(); ++j)
        rows[j * targets() + k] = sum / static_cast<double>(rounds()) - rows[j * targets() + k];
    }
    if (!ofRoundsToo) return;
    for (std::size_t j = 0; j < rounds(); ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < targets(); ++k) sum += rows[j * targets() + k];
      for (std::size_t k = 0; k < targets(); ++k)
        rows[j * targets() + k] -= sum / static_cast<double>(targets());
    }
  }

  static CheckScatter scatterOf(const std::vector<double>& residuals, std::size_t degreesOfFreedom) {
    CheckScatter scatter{0, static_cast<double>(degreesOfFreedom)};
    for (const double residual : residuals) scatter.sumOfSquares += square(residual);
    return scatter;
  }

  void evaluateDirections() {
    // Directions relative to the first round and to the first target (as in the standard) are small at any
    // setting of the circle.
    std::vector<double> rows;
    std::vector<double> turns;
    for (std::size_t j = 0; j < rounds(); ++j) {
      const Angle turn = wrapped(pair(j, 0).direction - pair(0, 0).direction);
      turns.push_back(turn.arcseconds());
      for (std::size_t k = 0; k < targets(); ++k)
        rows.push_back(wrapped(pair(j, k).direction - pair(0, k).direction - turn).arcseconds());
    }
    takeOrientations(rows, turns);
    takeOffMeans(rows, true);
    m_check.direction = scatterOf(rows, (rounds() - 1) * (targets() - 1));
    m_directions = std::move(rows);
  }

  void takeOrientations(const std::vector<double>& rows, std::vector<double> turns) {
    for (std::size_t j = 0; j < rounds(); ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < targets(); ++k) sum += rows[j * targets() + k];
      turns[j] += sum / static_cast<double>(targets());
    }
    constexpr double largestTurn = 180;  // arcsec: a larger turn means a knocked tripod or a reset circle
    const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
    m_check.isCircleReset = *most - *least > largestTurn;
    const double mean = meanOf(turns).value;
    for (const double turn : turns) m_orientations.push_back(m_check.isCircleReset ? unknown : turn - mean);
  }

  void evaluateVerticals() {
    std::vector<double> rows;
    for (std::size_t j = 0; j < rounds(); ++j)
      for (std::size_t k = 0; k < targets(); ++k)
        rows.push_back(wrapped(pair(j, k).vertical - pair(0, k).vertical).arcseconds());
    takeOffMeans(rows, false);
    m_check.vertical = scatterOf(rows, (rounds() - 1) * targets());
    for (std::size_t j = 0; j < rounds(); ++j)
      for (std::size_t k = 0; k < targets(); ++k)
        m_check.residuals.push_back({j, k, m_directions[j * targets() + k], rows[j * targets() + k]});
  }

  void evaluateFaces() {
    for (std::size_t j = 0; j < rounds(); ++j)
      for (std::size_t k = 0; k < targets(); ++k) {
        const FacePair& faces = pair(j, k);
        m_collimations.push_back(faces.halfDirection.arcseconds() * std::cos(faces.elevation.radians()));
        m_indices.push_back(faces.halfVertical.arcseconds());
      }
    m_check.collimation = meanOf(m_collimations);
    m_check.index = meanOf(m_indices);
  }

  double ofRound(const std::vector<double>& rows, std::size_t round) const {
    const auto first = rows.begin() + static_cast<std::ptrdiff_t>(round * targets());
    return meanOf({first, first + static_cast<std::ptrdiff_t>(targets())}).value;
  }

  std::vector<double> ofTarget(const std::vector<double>& rows, std::size_t target) const {
    std::vector<double> values;
    for (std::size_t j = 0; j < rounds(); ++j) values.push_back(rows[j * targets() + target]);
    return values;
  }

  /// F test of the targets' means against the scatter within targets.
  void compareTargets() {
    double between = 0, within = 0;
    for (std::size_t k = 0; k < targets(); ++k) {
      const std::vector<double> values = ofTarget(m_collimations, k);
      const PairMean mean = meanOf(values);
      between += static_cast<double>(rounds()) * square(mean.value - m_check.collimation.value);
      for (const double value : values) within += square(value - mean.value);
      m_check.perTarget.push_back({m_station.targets[k], elevationDeg(k), distanceM(k), mean.value,
                                   meanOf(ofTarget(m_indices, k)).value});
    }
    const double degreesOfFreedomBetween = static_cast<double>(targets()) - 1,
                 degreesOfFreedomWithin = static_cast<double>(targets() * (rounds() - 1));
    const double variance = within / degreesOfFreedomWithin;
    m_check.targetsDifferP =
        variance > square(roundingArcsec)
            ? fUpperTail(between / variance, degreesOfFreedomBetween, degreesOfFreedomWithin)
                  .value_or(unknown)
            : unknown;
  }

  double elevationDeg(std::size_t target) const {
    double sum = 0;
    for (std::size_t j = 0; j < rounds(); ++j) sum += pair(j, target).elevation.degrees();
    return sum / static_cast<double>(rounds());
  }

  double distanceM(std::size_t target) const {
    double sum = 0;
    int count = 0;
    for (std::size_t j = 0; j < rounds(); ++j)
      if (const double distance = pair(j, target).distanceM; distance > 0) {
        sum += distance;
        ++count;
      }
    return count > 0 ? sum / count : 0;
  }

  void followRounds() {
    std::vector<double> collimations, indices;
    for (std::size_t j = 0; j < rounds(); ++j) {
      collimations.push_back(ofRound(m_collimations, j));
      indices.push_back(ofRound(m_indices, j));
      m_check.course.push_back({m_station.rounds[j].name, collimations[j], indices[j], m_orientations[j]});
    }
    m_check.collimationSlope = slopeOf(collimations);
    m_check.indexSlope = slopeOf(indices);
    m_check.orientationSlope = slopeOf(m_orientations);
  }

  /// States the collimation together with the causes that these targets can show.
  void separateCauses() {
    measureSpread();
    // Elevations that differ only by pointing noise count as equal.
    constexpr double leastDegrees = 0.5, leastRatio = 1.1;
    const bool hasTilt = m_check.highestDeg - m_check.lowestDeg > leastDegrees;
    const bool hasDistance = m_check.nearestM > 0 && m_check.farthestM > leastRatio * m_check.nearestM;
    std::vector<HalfDifference> differences;
    for (std::size_t j = 0; j < rounds(); ++j)
      for (std::size_t k = 0; k < targets(); ++k)
        differences.push_back({pair(j, k).halfDirection.arcseconds(), pair(j, k).elevation.radians(),
                               m_check.perTarget[k].distanceM});
    m_check.causes = separateFaceCauses(differences, hasTilt, hasDistance);
    if (m_check.causes.collimation)
      m_check.collimation = *m_check.causes.collimation;
    else if (m_check.targetsDifferP < levelOfTests)
      widenByTargets();
  }

  /// Computes u of c from the differences between targets, with t − 1 degrees of freedom.
  void widenByTargets() {
    double squares = 0;
    for (const TargetMean& target : m_check.perTarget)
      squares += square(target.collimation - m_check.collimation.value);
    const auto count = static_cast<double>(targets());
    PairMean& mean = m_check.collimation;
    mean.u = std::sqrt(squares / (count - 1) / count);
    mean.scatter = mean.u / std::sqrt(mean.cofactor);
    mean.degreesOfFreedom = count - 1;
  }

  /// Finds the extreme elevations and, if all distances are known, the extreme distances.
  void measureSpread() {
    const auto& perTarget = m_check.perTarget;
    const auto [lowest, highest] = std::ranges::minmax_element(perTarget, {}, &TargetMean::elevationDeg);
    m_check.lowestDeg = lowest->elevationDeg;
    m_check.highestDeg = highest->elevationDeg;
    const auto [nearest, farthest] = std::ranges::minmax_element(perTarget, {}, &TargetMean::distanceM);
    if (!(nearest->distanceM > 0)) return;
    m_check.nearestM = nearest->distanceM;
    m_check.farthestM = farthest->distanceM;
  }

  const StationRounds& m_station;
  StationCheck m_check{};
  std::vector<double> m_directions, m_orientations, m_collimations, m_indices;
};

}  // namespace

double CheckScatter::s() const {
  return degreesOfFreedom > 0 ? std::sqrt(sumOfSquares / degreesOfFreedom) : unknown;
}

void CheckScatter::add(const CheckScatter& other) {
  if (!(other.degreesOfFreedom > 0)) return;
  sumOfSquares += other.sumOfSquares;
  degreesOfFreedom += other.degreesOfFreedom;
}

StationCheck checkStation(const StationRounds& station) {
  return StationEvaluation(station).evaluate();
}

}  // namespace alidade
