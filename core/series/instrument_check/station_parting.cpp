#include "core/series/instrument_check/station_parting.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/series/instrument_check/round_difference.h"

namespace alidade {

namespace {

using RoundGroup = std::vector<std::size_t>;  // indices of rounds, ascending

/// Groups of rounds that agree on the places of their targets.
class StationParting {
 public:
  explicit StationParting(StationRounds station) : m_station(std::move(station)) {}

  std::vector<StationRounds> part() {
    if (!findGroups()) return {std::move(m_station)};
    std::vector<StationRounds> parts;
    for (std::size_t group = 0; group < m_groups.size(); ++group) parts.push_back(partOf(group));
    return parts;
  }

 private:
  /// Returns false if the rounds stay together: there is one group, or the groups are unclear.
  bool findGroups() {
    constexpr std::size_t mostGroups = 1000;
    for (std::size_t round = 0; round < m_station.rounds.size(); ++round) {
      if (m_station.rounds[round].pairs.empty()) continue;
      const std::optional<std::size_t> group = groupOf(round);
      if (m_isReversed || m_groups.size() > mostGroups) return false;
      if (group)
        m_groups[*group].push_back(round);
      else
        m_groups.push_back({round});
    }
    return m_groups.size() > 1 &&
           std::ranges::all_of(m_groups, [](const RoundGroup& group) { return group.size() > 1; });
  }

  /// The last group that agrees with the round; the last of all groups if none has a target of the round.
  /// Absent if groups have targets of the round but none agrees.
  std::optional<std::size_t> groupOf(std::size_t round) {
    bool isCompared = false;
    for (std::size_t group = m_groups.size(); group-- > 0;)
      for (const std::size_t other : {m_groups[group].back(), m_groups[group].front()}) {
        const ObservedRound &one = m_station.rounds[other], &two = m_station.rounds[round];
        if (commonTargets(one, two) == 0) continue;
        const auto difference = differenceOf(one, two, leastBetweenStations);
        if (!difference) return group;
        isCompared = true;
        m_isReversed = m_isReversed || difference->isReversed;
      }
    if (isCompared || m_groups.empty()) return std::nullopt;
    return m_groups.size() - 1;
  }

  StationRounds partOf(std::size_t group) const {
    StationRounds part;
    part.station = m_station.station + " (" + std::to_string(group + 1) + ")";
    part.file = m_station.file;
    part.circles = m_station.circles;
    part.targets = m_station.targets;
    std::set<std::string> names;
    for (const std::size_t round : m_groups[group]) {
      part.rounds.push_back(m_station.rounds[round]);
      names.insert(m_station.rounds[round].name);
    }
    for (const LeftOutReadings& left : m_station.leftOut)
      if (names.contains(left.round)) part.leftOut.push_back(left);
    keepTargetsSighted(part);
    if (group > 0) part.parted = reasonFor(group);
    return part;
  }

  static void keepTargetsSighted(StationRounds& part) {
    std::set<std::size_t> sighted;
    for (const ObservedRound& round : part.rounds)
      for (const FacePair& pair : round.pairs) sighted.insert(pair.target);
    std::vector<std::string> names;
    std::vector<std::size_t> numbers(part.targets.size());
    for (const std::size_t target : sighted) {
      numbers[target] = names.size();
      names.push_back(part.targets[target]);
    }
    part.targets = std::move(names);
    for (ObservedRound& round : part.rounds)
      for (FacePair& pair : round.pairs) pair.target = numbers[pair.target];
  }

  std::string reasonFor(std::size_t group) const {
    const ObservedRound &before = m_station.rounds[m_groups[group - 1].front()],
                        &here = m_station.rounds[m_groups[group].front()];
    const auto difference = differenceOf(before, here, leastBetweenStations);
    if (!difference)
      return Phrase::of(
          "Rounds from %1 on show other targets than those before: they are evaluated as another "
          "station.",
          linesOf(here.pairs.front()));
    const FacePair &one = before.pairs[difference->first], &two = here.pairs[difference->second];
    return Phrase::of(
        "Target %1 (%2) is %3° from where it was sighted in an earlier round (%4): these rounds are "
        "evaluated as "
        "another station.",
        quotation(m_station.targets[two.target]), linesOf(two), displayText(difference->by.degrees(), 1),
        linesOf(one));
  }

  StationRounds m_station;
  std::vector<RoundGroup> m_groups;
  bool m_isReversed = false;
};

}  // namespace

std::vector<StationRounds> partedByGeometry(StationRounds station) {
  return StationParting(std::move(station)).part();
}

}  // namespace alidade
