#include "core/series/instrument_check/rounds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/phrase.h"
#include "core/series/instrument_check/station_parting.h"
#include "core/session/face.h"

namespace alidade {

namespace {

using TargetFace = std::pair<std::size_t, int>;

/// Readings of one station with the round of each, counted from 0.
struct Numbered {
  std::vector<const FaceReading*> readings;
  std::vector<std::size_t> rounds;
  std::vector<std::string> names;  ///< of the rounds
};

/// Numbers the rounds stated in the file. A round that recurs with the same targets counts as another round.
void takeStated(Numbered& numbered) {
  struct Seen {
    std::size_t pass = 0, run = 0;
  };
  std::map<std::pair<std::string, TargetFace>, Seen> seen;
  std::map<std::pair<std::string, std::size_t>, std::size_t> rounds;
  std::size_t run = 0;
  const std::string* last = nullptr;
  for (const FaceReading* reading : numbered.readings) {
    if (!last || *last != reading->round) ++run;
    last = &reading->round;
    Seen& at = seen[{reading->round, {reading->target, reading->face}}];
    if (at.run != run) ++at.pass;
    at.run = run;
    const auto [known, isNew] = rounds.try_emplace({reading->round, at.pass}, rounds.size());
    if (isNew) {
      const std::string name = reading->round.empty() ? "1" : reading->round;
      numbered.names.push_back(at.pass == 1 ? name : name + " (" + std::to_string(at.pass) + ")");
    }
    numbered.rounds.push_back(known->second);
  }
}

/// True if every target was sighted equally often in each face.
bool isBalanced(const Numbered& numbered) {
  std::map<TargetFace, std::size_t> counts;
  std::set<std::size_t> targets;
  for (const FaceReading* reading : numbered.readings) {
    ++counts[{reading->target, reading->face}];
    targets.insert(reading->target);
  }
  return counts.size() == 2 * targets.size() &&
         std::all_of(counts.begin(), counts.end(),
                     [&counts](const auto& count) { return count.second == counts.begin()->second; });
}

void countVisits(Numbered& numbered) {
  std::map<TargetFace, std::size_t> visits;
  for (const FaceReading* reading : numbered.readings)
    numbered.rounds.push_back(visits[{reading->target, reading->face}]++);
}

/// Finds where rounds begin from the order of the sightings.
class RoundBounds {
 public:
  explicit RoundBounds(Numbered& numbered) : m_numbered(numbered) {}

  void find() {
    for (std::size_t i = 0; i < m_numbered.readings.size(); ++i) {
      if (begins(i)) {
        m_seen.clear();
        m_both = 0;
        m_start = i;
        ++m_round;
      }
      const auto [target, face] = key(i);
      if (m_seen.insert({target, face}).second && m_seen.contains({target, 3 - face})) ++m_both;
      m_numbered.rounds.push_back(m_round);
    }
  }

 private:
  TargetFace key(std::size_t i) const {
    return {m_numbered.readings[i]->target, m_numbered.readings[i]->face};
  }

  bool begins(std::size_t i) const {
    return m_seen.contains(key(i)) && haveMostBothFaces() && !closesHorizon(i);
  }

  bool haveMostBothFaces() const {
    const std::size_t targets = m_seen.size() - m_both;
    return 2 * m_both > targets;
  }

  /// True if this repeated sighting of the first target, in the other face, closes the horizon: no sighting
  /// follows, or the next sighting begins a round at the same target in the first face.
  bool closesHorizon(std::size_t i) const {
    const auto [target, face] = key(i);
    const auto [firstTarget, firstFace] = key(m_start);
    if (target != firstTarget || face == firstFace) return false;
    return i + 1 == m_numbered.readings.size() || key(i + 1) == TargetFace{target, firstFace};
  }

  Numbered& m_numbered;
  std::set<TargetFace> m_seen;  ///< in the current round
  std::size_t m_both = 0;       ///< targets seen in both faces
  std::size_t m_start = 0, m_round = 0;
};

void numberRounds(Numbered& numbered) {
  const bool isStated = std::any_of(numbered.readings.begin(), numbered.readings.end(),
                                    [](const FaceReading* reading) { return !reading->round.empty(); });
  if (isStated) return takeStated(numbered);
  if (isBalanced(numbered))
    countVisits(numbered);
  else
    RoundBounds(numbered).find();
  for (const std::size_t round : numbered.rounds)
    while (numbered.names.size() <= round)
      numbered.names.push_back(std::to_string(numbered.names.size() + 1));
}

/// The mean of a target's sightings in one face, with both circles converted to face 1.
struct FaceMean {
  int count = 0;
  FaceOneReading first = {};
  Angle horizontal = {}, vertical = {};  ///< sums of differences from the first sighting
  double distanceM = 0;                  ///< sum
  int distances = 0;
  std::size_t line = 0;  ///< of the first sighting

  void add(const FaceReading& reading, VerticalCircle circle) {
    const FaceOneReading read = inFaceOne(reading.horizontal, reading.vertical, reading.face, circle);
    if (count++ == 0) {
      first = read;
      line = reading.line;
    }
    horizontal = horizontal + wrapped(read.horizontal - first.horizontal);
    vertical = vertical + wrapped(read.vertical - first.vertical);
    if (reading.distanceM > 0) {
      distanceM += reading.distanceM;
      ++distances;
    }
  }
  FaceOneReading mean() const {
    return {first.horizontal + horizontal * (1.0 / count), first.vertical + vertical * (1.0 / count)};
  }
};

FacePair pairOf(const FaceMean& one, const FaceMean& two, std::size_t target, VerticalCircle circle) {
  const FaceOneReading read = one.mean(), equivalent = two.mean();
  FacePair pair;
  pair.target = target;
  pair.halfDirection = wrapped(read.horizontal - equivalent.horizontal) * 0.5;
  pair.halfVertical = wrapped(read.vertical - equivalent.vertical) * 0.5;
  pair.direction = wrapped(read.horizontal - pair.halfDirection, Angle::fromDegrees(180));
  pair.vertical = wrapped(read.vertical - pair.halfVertical);
  pair.elevation = circle == VerticalCircle::Zenith ? Angle::fromDegrees(90) - pair.vertical : pair.vertical;
  const int distances = one.distances + two.distances;
  if (distances > 0) pair.distanceM = (one.distanceM + two.distanceM) / distances;
  pair.lineOfFaceOne = one.line;
  pair.lineOfFaceTwo = two.line;
  return pair;
}

bool areFarApart(const FacePair& pair) {
  constexpr double most = 1;  // degree, of half the difference of the faces; axis errors are smaller
  return std::abs(pair.halfDirection.degrees()) > most || std::abs(pair.halfVertical.degrees()) > most;
}

/// Keeps the pairs of complete rounds.
class Completion {
 public:
  explicit Completion(StationRounds& station) : m_station(station) {}

  void keep() {
    for (std::size_t target = 0; target < m_station.targets.size(); ++target) m_targets.insert(target);
    while (dropWorst()) {
    }
    renumber();
  }

 private:
  /// Drops the round or target with the largest share of missing pairs. False if none is missing.
  bool dropWorst() {
    std::vector<std::size_t> perTarget(m_station.targets.size());
    std::size_t fewest = m_targets.size();
    for (const ObservedRound& round : m_station.rounds) {
      fewest = std::min(fewest, round.pairs.size());
      for (const FacePair& pair : round.pairs) ++perTarget[pair.target];
    }
    const std::size_t rounds = m_station.rounds.size();
    if (rounds == 0 || m_targets.empty() || fewest == m_targets.size()) return false;
    std::size_t rarest = rounds;
    for (const std::size_t target : m_targets) rarest = std::min(rarest, perTarget[target]);
    const double roundLacks = 1 - static_cast<double>(fewest) / static_cast<double>(m_targets.size());
    const double targetLacks = 1 - static_cast<double>(rarest) / static_cast<double>(rounds);
    if (targetLacks > roundLacks)
      dropTargets(perTarget, rarest);
    else
      dropRounds(fewest);
    return true;
  }

  void dropTargets(const std::vector<std::size_t>& perTarget, std::size_t rarest) {
    const auto isRare = [&](std::size_t target) { return perTarget[target] == rarest; };
    for (const std::size_t target : m_targets)
      if (isRare(target)) m_station.leftOut.push_back({LeftOut::RareTarget, {}, m_station.targets[target]});
    std::erase_if(m_targets, isRare);
    for (ObservedRound& round : m_station.rounds)
      std::erase_if(round.pairs, [&](const FacePair& pair) { return isRare(pair.target); });
  }

  void dropRounds(std::size_t fewest) {
    for (const ObservedRound& round : m_station.rounds)
      if (round.pairs.size() == fewest)
        m_station.leftOut.push_back({LeftOut::IncompleteRound, round.name, firstMissing(round)});
    std::erase_if(m_station.rounds,
                  [fewest](const ObservedRound& round) { return round.pairs.size() == fewest; });
  }

  std::string firstMissing(const ObservedRound& round) const {
    for (const std::size_t target : m_targets) {
      const bool isThere = std::any_of(round.pairs.begin(), round.pairs.end(),
                                       [target](const FacePair& pair) { return pair.target == target; });
      if (!isThere) return m_station.targets[target];
    }
    return {};
  }

  void renumber() {
    std::map<std::size_t, std::size_t> numbers;
    std::vector<std::string> names;
    for (const std::size_t target : m_targets) {
      numbers[target] = names.size();
      names.push_back(m_station.targets[target]);
    }
    m_station.targets = std::move(names);
    for (ObservedRound& round : m_station.rounds)
      for (FacePair& pair : round.pairs) pair.target = numbers.at(pair.target);
  }

  StationRounds& m_station;
  std::set<std::size_t> m_targets;  ///< the targets kept
};

/// Groups the sightings of one station by round and target.
class StationSorting {
 public:
  StationSorting(const CheckReadings& readings, std::size_t station, Numbered numbered)
      : m_readings(readings), m_numbered(std::move(numbered)) {
    m_result.station = readings.stations[station];
    m_result.circles = readings.circles;
    numberRounds(m_numbered);
    if (const std::size_t file = m_numbered.readings.front()->file; file < readings.files.size())
      m_result.file = readings.files[file];
  }

  /// The rounds as observed, complete or incomplete.
  StationRounds sort() {
    for (std::size_t i = 0; i < m_numbered.readings.size(); ++i)
      take(*m_numbered.readings[i], m_numbered.rounds[i]);
    for (const std::string& name : m_numbered.names) m_result.rounds.push_back({name, {}});
    for (const auto& [key, faces] : m_means) pairUp(key.first, key.second, faces.first, faces.second);
    return std::move(m_result);
  }

 private:
  void take(const FaceReading& reading, std::size_t round) {
    const auto [known, isNew] = m_targets.try_emplace(reading.target, m_targets.size());
    if (isNew) m_result.targets.push_back(m_readings.targets[reading.target]);
    auto& [one, two] = m_means[{round, known->second}];
    FaceMean& mean = reading.face == 1 ? one : two;
    mean.add(reading, m_readings.circle);
    if (mean.count == 2) leaveOut(LeftOut::Repeated, round, known->second, {});
  }

  void pairUp(std::size_t round, std::size_t target, const FaceMean& one, const FaceMean& two) {
    if (one.count == 0 || two.count == 0) return leaveOut(LeftOut::OneFace, round, target, {});
    const FacePair pair = pairIn(one, two, target);
    if (areFarApart(pair))
      leaveOut(LeftOut::FarApart, round, target, linesOf(pair));
    else
      m_result.rounds[round].pairs.push_back(pair);
  }

  FacePair pairIn(const FaceMean& one, const FaceMean& two, std::size_t target) const {
    FacePair pair = pairOf(one, two, target, m_readings.circle);
    if (m_readings.circles == CheckCircles::VerticalOnly) pair.direction = pair.halfDirection = {};
    if (m_readings.circles == CheckCircles::HorizontalOnly)
      pair.vertical = pair.halfVertical = pair.elevation = {};
    return pair;
  }

  void leaveOut(LeftOut why, std::size_t round, std::size_t target, const std::string& lines) {
    m_result.leftOut.push_back({why, m_numbered.names[round], m_result.targets[target], lines});
  }

  const CheckReadings& m_readings;
  Numbered m_numbered;
  std::map<std::size_t, std::size_t> m_targets;  ///< index at the station by index among all targets
  std::map<std::pair<std::size_t, std::size_t>, std::pair<FaceMean, FaceMean>>
      m_means;  ///< by round and target
  StationRounds m_result;
};

}  // namespace

std::string linesOf(const FacePair& pair) {
  return Phrase::of("lines %1 and %2", std::min(pair.lineOfFaceOne, pair.lineOfFaceTwo),
                    std::max(pair.lineOfFaceOne, pair.lineOfFaceTwo));
}

std::vector<StationRounds> completeRounds(const CheckReadings& readings) {
  std::vector<Numbered> numbered(readings.stations.size());
  for (const FaceReading& reading : readings.readings) numbered[reading.station].readings.push_back(&reading);
  std::vector<StationRounds> stations;
  for (std::size_t station = 0; station < numbered.size(); ++station)
    if (!numbered[station].readings.empty())
      for (StationRounds& part :
           partedByGeometry(StationSorting(readings, station, std::move(numbered[station])).sort())) {
        Completion(part).keep();
        stations.push_back(std::move(part));
      }
  return stations;
}

}  // namespace alidade
