#include "core/series/shared_causes/effect_block.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd;

namespace {

constexpr std::size_t mostSizes = 64;  // per block; each is a row of a dense matrix

CauseOwner ownerOf(const Effect& effect) {
  switch (effect.source) {
    case ErrorSource::Guideway:
      return CauseOwner::Guideway;
    case ErrorSource::Instrument:
      return CauseOwner::Instrument;
    case ErrorSource::Time:
    case ErrorSource::Reading:
      break;
  }
  return CauseOwner::Time;
}

using Sessions = std::vector<std::size_t>;
using Groups = std::vector<std::pair<std::string, Sessions>>;

/// Groups `sessions` by owner, in the order of the first session of each. A session without a serial has an
/// owner of its own.
Groups groupsOf(const std::vector<SessionOwners>& owners, const Sessions& sessions, CauseOwner kind) {
  Groups groups;
  std::map<std::string, std::size_t> known;
  for (const std::size_t s : sessions) {
    const std::string& serial = kind == CauseOwner::Instrument ? owners[s].instrument : owners[s].guideway;
    const auto [place, isNew] = known.try_emplace(serial, groups.size());
    if (isNew || serial.empty()) {
      place->second = groups.size();
      groups.push_back({serial, {}});
    }
    groups[place->second].second.push_back(s);
  }
  return groups;
}

Sessions everySession(std::size_t count) {
  Sessions all(count);
  for (std::size_t s = 0; s < count; ++s) all[s] = s;
  return all;
}

/// A row for each of `sessions`, with 1 in the column of its group and 0 in the others.
MatrixXd membership(const Sessions& sessions, const Groups& groups) {
  MatrixXd features = MatrixXd::Zero(std::ssize(sessions), std::ssize(groups));
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::size_t s : groups[g].second)
      features(std::ranges::lower_bound(sessions, s) - sessions.begin(), static_cast<Index>(g)) = 1;
  return features;
}

/// Adds the blocks of an effect in `sessions`; `groups` are these sessions by owner.
void addEffectBlocks(std::vector<EffectBlock>& blocks, const EffectColumns& columns, const Sessions& sessions,
                     const Groups& groups) {
  constexpr double differing = 0.01;  // odds that an effect of an instrument or a guideway has a size of its
                                      // own in each session
  const CauseOwner owner = ownerOf(*columns.effect);
  const std::size_t numbers = columns.effect->parameters.size();
  if (owner != CauseOwner::Time)
    for (const auto& [serial, own] : groups)
      blocks.push_back({.effect = &columns,
                        .owner = owner,
                        .sizes = SizesKind::One,
                        .serial = serial,
                        .sessions = own,
                        .logPrior = std::log(effectOdds() / static_cast<double>(groups.size()))});
  if (columns.effect->response != Response::Linear) return;
  const bool isOfEach = owner == CauseOwner::Time || groups.size() == sessions.size();
  if (!isOfEach && groups.size() > 1 && groups.size() * numbers <= mostSizes)
    blocks.push_back({.effect = &columns,
                      .owner = owner,
                      .sizes = SizesKind::PerOwner,
                      .sessions = sessions,
                      .features = membership(sessions, groups),
                      .logPrior = std::log(effectOdds())});
  if (sessions.size() > 1 && sessions.size() * numbers <= mostSizes)
    blocks.push_back({.effect = &columns,
                      .owner = isOfEach ? owner : CauseOwner::Time,
                      .sizes = SizesKind::PerSession,
                      .sessions = sessions,
                      .features = MatrixXd::Identity(std::ssize(sessions), std::ssize(sessions)),
                      .logPrior = std::log(isOfEach ? effectOdds() : differing)});
}

void addPatternBlocks(std::vector<EffectBlock>& blocks, const SharedColumns& columns,
                      const std::vector<SessionOwners>& owners) {
  constexpr double odds = 0.04;  // of all patterns together, as in one session
  constexpr std::size_t fewest = 3;
  const std::size_t before = blocks.size();
  const Sessions every = everySession(owners.size());
  for (const EffectColumns& pattern : columns.all()) {
    if (!pattern.isPattern) continue;
    const CauseOwner owner = ownerOf(*pattern.effect);
    if (owner == CauseOwner::Time) {
      blocks.push_back({.effect = &pattern, .owner = owner, .sessions = every});
      continue;
    }
    for (const auto& [serial, sessions] : groupsOf(owners, every, owner))
      if (!serial.empty() && sessions.size() >= fewest)
        blocks.push_back({.effect = &pattern, .owner = owner, .serial = serial, .sessions = sessions});
  }
  for (std::size_t i = before; i < blocks.size(); ++i)
    blocks[i].logPrior = std::log(odds / static_cast<double>(blocks.size() - before));
}

}  // namespace

double effectOdds() {
  return 0.04;
}

std::vector<EffectBlock> effectBlocks(const SharedColumns& columns, const std::vector<SessionOwners>& owners,
                                      const std::vector<std::string>& leftOut) {
  const Sessions every = everySession(owners.size());
  const Groups ofInstruments = groupsOf(owners, every, CauseOwner::Instrument),
               ofGuideways = groupsOf(owners, every, CauseOwner::Guideway);
  std::vector<EffectBlock> blocks;
  for (const EffectColumns& own : columns.effects()) {
    if (std::ranges::find(leftOut, own.effect->id) != leftOut.end()) continue;
    const CauseOwner owner = ownerOf(*own.effect);
    if (!own.own) {
      addEffectBlocks(blocks, own, every, owner == CauseOwner::Instrument ? ofInstruments : ofGuideways);
      continue;
    }
    Sessions having;
    for (const std::size_t s : every)
      if (columns.of(own.effect->id, owners[s].own) == &own) having.push_back(s);
    addEffectBlocks(blocks, own, having, groupsOf(owners, having, owner));
  }
  if (owners.size() > 1) addPatternBlocks(blocks, columns, owners);
  return blocks;
}

EffectBlock drifting(const EffectBlock& block, const std::vector<SessionOwners>& owners) {
  constexpr std::size_t fewest = 4;
  constexpr Index sines = 4;
  constexpr double odds = 0.1;  // against a constant size
  if (block.sizes != SizesKind::One || block.isPattern() || block.sessions.size() < fewest ||
      block.columns().effect->response != Response::Linear)
    return {};
  EffectBlock drifting = block;
  drifting.sizes = SizesKind::Drifting;
  drifting.logPrior += std::log(odds);
  drifting.features.resize(std::ssize(block.sessions), 1 + sines);
  for (std::size_t i = 0; i < block.sessions.size(); ++i) {
    const auto row = static_cast<Index>(i);
    drifting.features(row, 0) = 1;
    for (Index k = 1; k <= sines; ++k) {
      const double frequency = (static_cast<double>(k) - 0.5) * M_PI;
      drifting.features(row, k) =
          std::sqrt(2) * std::sin(frequency * owners[block.sessions[i]].time) / frequency;
    }
  }
  return drifting;
}

}  // namespace alidade
