#include "core/series/instrument_check/plausibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/statistics.h"
#include "core/base/visible_text.h"
#include "core/series/instrument_check/round_difference.h"
#include "core/series/instrument_check/station_parting.h"

namespace alidade {

namespace {

/// 12″, 3.4′, 2.1°: an angle in the usual unit for its size.
std::string accessibleAngle(double arcseconds) {
  constexpr double perMinute = 60, perDegree = 3600;
  const double size = std::abs(arcseconds);
  if (size >= perDegree) return displayText(size / perDegree, 1) + "°";
  if (size >= 2 * perMinute) return displayText(size / perMinute, 1) + "′";
  return displayText(size, 0) + "″";
}

/// One number of each pair, grouped by round, arcsec.
using PairNumbers = std::vector<std::vector<double>>;

/// Subtracts from each target's numbers their median over the rounds.
void takeOffMedians(PairNumbers& numbers) {
  for (std::size_t k = 0; k < numbers.front().size(); ++k) {
    std::vector<double> column;
    for (const std::vector<double>& row : numbers) column.push_back(row[k]);
    const double middle = medianOf(std::move(column));
    for (std::vector<double>& row : numbers) row[k] -= middle;
  }
}

/// Tests whether the figures of a station are plausible.
class StationPlausibility {
 public:
  StationPlausibility(const StationRounds& station, const StationCheck& check, const CheckBounds& bounds)
      : m_station(station), m_check(check), m_bounds(bounds) {}

  /// The sentence without the name of the file; absent if all figures are plausible.
  std::optional<std::string> problem() const {
    if (auto problem = facesFarApart()) return problem;
    if (m_station.rounds.empty() || m_station.targets.empty()) return std::nullopt;
    if (auto problem = targetElsewhere()) return problem;
    if (auto problem = departure()) return problem;
    return figures();
  }

 private:
  const FacePair& pair(std::size_t round, std::size_t target) const {
    return m_station.rounds[round].pairs[target];
  }
  std::string targetName(const FacePair& pair) const { return quotation(m_station.targets[pair.target]); }

  std::optional<std::string> facesFarApart() const {
    const auto isFar = [](const LeftOutReadings& left) { return left.why == LeftOut::FarApart; };
    const auto first = std::ranges::find_if(m_station.leftOut, isFar);
    if (first == m_station.leftOut.end()) return std::nullopt;
    const auto apart = static_cast<double>(std::ranges::count_if(m_station.leftOut, isFar));
    const auto pairs = static_cast<double>(m_check.pairs());
    if (apart <= m_bounds.farApart * (apart + pairs)) return std::nullopt;
    return Phrase::of(
        "%1: the faces of target %2 differ by more than 2°, which is no collimation or index: check the face "
        "and the target of these lines",
        first->lines, quotation(first->target));
  }

  /// The sentence on a target whose place differs from its place in the first round.
  std::optional<std::string> targetElsewhere() const {
    for (std::size_t round = 1; round < m_station.rounds.size(); ++round) {
      const ObservedRound &before = m_station.rounds.front(), &here = m_station.rounds[round];
      const auto difference = differenceOf(before, here, leastBetweenStations);
      if (!difference) continue;
      const FacePair &one = before.pairs[difference->first], &two = here.pairs[difference->second];
      if (difference->isReversed)
        return Phrase::of(
            "%1: the horizontal circle counts in the opposite direction to that in %2 (target %3): set the "
            "same direction in all rounds, or check them one by one",
            linesOf(two), linesOf(one), targetName(two));
      return Phrase::of(
          "%1: target %2 is %3 from where it was sighted in %4: correct the reading; or name the stations if "
          "the "
          "instrument was moved, or the targets if they are different ones",
          linesOf(two), targetName(two), accessibleAngle(difference->by.arcseconds()), linesOf(one));
    }
    return std::nullopt;
  }

  template <typename Number>
  PairNumbers numbersOf(const Number& number) const {
    PairNumbers numbers(m_station.rounds.size());
    for (std::size_t j = 0; j < m_station.rounds.size(); ++j)
      for (std::size_t k = 0; k < m_station.targets.size(); ++k)
        numbers[j].push_back(number(pair(j, k), pair(0, k)));
    return numbers;
  }

  /// Directions of each round relative to the first round, minus the median of the round.
  PairNumbers directions() const {
    PairNumbers numbers = numbersOf([](const FacePair& here, const FacePair& first) {
      return (here.direction - first.direction).arcseconds();
    });
    constexpr double fullTurn = 1296000;
    for (std::vector<double>& row : numbers) {
      const double start = row.front();
      for (double& value : row) value = std::remainder(value - start, fullTurn);
      const double turn = medianOf(row);
      for (double& value : row) value -= turn;
    }
    return numbers;
  }

  /// The sentence on the pair whose number departs from its median over the rounds by more than the bound.
  std::optional<std::string> departure() const {
    using Words = std::pair<PairNumbers, const char*>;
    std::array<Words, 4> kinds{
        Words{directions(), PHRASE_LATER("Phrase", "direction")},
        Words{numbersOf([](const FacePair& here, const FacePair& first) {
                return wrapped(here.vertical - first.vertical).arcseconds();
              }),
              PHRASE_LATER("Phrase", "zenith angle")},
        Words{numbersOf([](const FacePair& here, const FacePair&) {
                return here.halfDirection.arcseconds() * std::cos(here.elevation.radians());
              }),
              PHRASE_LATER("Phrase", "collimation")},
        Words{numbersOf([](const FacePair& here, const FacePair&) { return here.halfVertical.arcseconds(); }),
              PHRASE_LATER("Phrase", "index")}};
    for (auto& [numbers, name] : kinds) {
      takeOffMedians(numbers);
      if (auto sentence = departureOf(numbers, name)) return sentence;
    }
    return std::nullopt;
  }

  std::optional<std::string> departureOf(const PairNumbers& numbers, const char* name) const {
    std::size_t round = 0, target = 0;
    for (std::size_t j = 0; j < numbers.size(); ++j)
      for (std::size_t k = 0; k < numbers[j].size(); ++k)
        if (std::abs(numbers[j][k]) > std::abs(numbers[round][target])) {
          round = j;
          target = k;
        }
    const double most = numbers[round][target];
    if (!(std::abs(most) > m_bounds.departure)) return std::nullopt;
    const FacePair& worst = pair(round, target);
    return Phrase::of(
        "%1: the %2 of target %3 departs by %4 from its median over the rounds: a reading is wrong, or the "
        "circle or the tripod moved within the round; correct these lines or leave the round out",
        linesOf(worst), Phrase::of(name), targetName(worst), accessibleAngle(most));
  }

  std::optional<std::string> figures() const {
    const auto beyond = [this](double value, double most, const char* name) -> std::optional<std::string> {
      if (!(std::abs(value) > most)) return std::nullopt;
      return figureProblem(name, accessibleAngle(value));
    };
    if (auto s = beyond(m_check.direction.s(), m_bounds.scatter, PHRASE_LATER("Phrase", "s of a direction")))
      return s;
    if (auto s =
            beyond(m_check.vertical.s(), m_bounds.scatter, PHRASE_LATER("Phrase", "s of a zenith angle")))
      return s;
    if (auto c = beyond(m_check.collimation.value, m_bounds.axisError, PHRASE_LATER("Phrase", "collimation")))
      return c;
    if (auto index = beyond(m_check.index.value, m_bounds.axisError, PHRASE_LATER("Phrase", "index")))
      return index;
    if (m_check.causes.tilt)
      if (auto tilt = beyond(certainSize(*m_check.causes.tilt), m_bounds.axisError,
                             PHRASE_LATER("Phrase", "tilt of the trunnion axis")))
        return tilt;
    if (m_check.causes.lineOfSight && certainSize(*m_check.causes.lineOfSight) > m_bounds.lineOfSight)
      return figureProblem(PHRASE_LATER("Phrase", "offset of the line of sight"),
                           displayText(std::abs(m_check.causes.lineOfSight->other), 1) + " mm");
    return std::nullopt;
  }

  /// The size of a cause minus three standard uncertainties, ≥ 0: similar targets determine a cause poorly.
  static double certainSize(const TwoCauses& causes) {
    constexpr double uncertainties = 3;
    return std::max(0.0, std::abs(causes.other) - uncertainties * causes.uOther);
  }

  std::string figureProblem(const char* name, const std::string& size) const {
    return Phrase::of(
        "lines %1 to %2: %3 would be %4, which no theodolite has: these are not rounds in two faces to fixed "
        "targets",
        firstLine(), lastLine(), Phrase::of(name), size);
  }

  std::size_t firstLine() const {
    std::size_t line = pair(0, 0).lineOfFaceOne;
    for (const ObservedRound& round : m_station.rounds)
      for (const FacePair& each : round.pairs)
        line = std::min({line, each.lineOfFaceOne, each.lineOfFaceTwo});
    return line;
  }
  std::size_t lastLine() const {
    std::size_t line = 0;
    for (const ObservedRound& round : m_station.rounds)
      for (const FacePair& each : round.pairs)
        line = std::max({line, each.lineOfFaceOne, each.lineOfFaceTwo});
    return line;
  }

  const StationRounds& m_station;
  const StationCheck& m_check;
  const CheckBounds& m_bounds;
};

}  // namespace

std::optional<Problem> implausibility(const std::vector<StationRounds>& stations,
                                      const InstrumentCheck& check, const CheckBounds& bounds) {
  std::optional<Problem> first;
  std::size_t more = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const auto sentence = StationPlausibility(stations[i], check.stations[i], bounds).problem();
    if (!sentence) continue;
    if (first)
      ++more;
    else
      first = Problem{stations[i].file.empty() ? *sentence : quotation(stations[i].file) + " " + *sentence};
  }
  if (first && more > 0) first->what = Phrase::of("%1 (and %2 more)", first->what, more);
  return first;
}

}  // namespace alidade
