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

/// The sessions of each owner, in the order of their first session. A session without a serial has an owner
/// of its own.
std::vector<std::pair<std::string, std::vector<std::size_t>>> sessionsOf(
    const std::vector<SessionOwners>& owners, CauseOwner kind) {
  std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
  std::map<std::string, std::size_t> known;
  for (std::size_t s = 0; s < owners.size(); ++s) {
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

std::vector<std::size_t> everySession(std::size_t count) {
  std::vector<std::size_t> all(count);
  for (std::size_t s = 0; s < count; ++s) all[s] = s;
  return all;
}

void addPatternBlocks(std::vector<EffectBlock>& blocks, const std::vector<SessionOwners>& owners) {
  constexpr double odds = 0.04;  // of any pattern, as in one session
  constexpr std::size_t fewest = 3;
  const std::size_t before = blocks.size();
  for (std::size_t e = effectColumns().size(); e < sharedColumns().size(); ++e) {
    const CauseOwner owner = ownerOf(*sharedColumns()[e].effect);
    if (owner == CauseOwner::Time) {
      blocks.push_back({.effect = e, .owner = owner, .sessions = everySession(owners.size())});
      continue;
    }
    for (const auto& [serial, sessions] : sessionsOf(owners, owner))
      if (!serial.empty() && sessions.size() >= fewest)
        blocks.push_back({.effect = e, .owner = owner, .serial = serial, .sessions = sessions});
  }
  for (std::size_t i = before; i < blocks.size(); ++i)
    blocks[i].logPrior = std::log(odds / static_cast<double>(blocks.size() - before));
}

}  // namespace

double effectOdds() {
  return 0.04;
}

std::vector<EffectBlock> effectBlocks(const std::vector<SessionOwners>& owners,
                                      const std::vector<std::string>& leftOut) {
  constexpr double differing = 0.01;  // odds that an effect which an owner should share has a size of its own
                                      // in each session
  const auto ofInstruments = sessionsOf(owners, CauseOwner::Instrument),
             ofGuideways = sessionsOf(owners, CauseOwner::Guideway);
  std::vector<EffectBlock> blocks;
  for (std::size_t e = 0; e < effectColumns().size(); ++e) {
    const Effect& effect = *effectColumns()[e].effect;
    if (std::ranges::find(leftOut, effect.id) != leftOut.end()) continue;
    const CauseOwner owner = ownerOf(effect);
    const auto& groups = owner == CauseOwner::Instrument ? ofInstruments : ofGuideways;
    const std::size_t numbers = effect.parameters.size();
    if (owner != CauseOwner::Time)
      for (const auto& [serial, sessions] : groups)
        blocks.push_back({.effect = e,
                          .owner = owner,
                          .sizes = SizesKind::One,
                          .serial = serial,
                          .sessions = sessions,
                          .logPrior = std::log(effectOdds() / static_cast<double>(groups.size()))});
    if (effect.response != Response::Linear) continue;
    if (owner != CauseOwner::Time && groups.size() > 1 && groups.size() < owners.size() &&
        groups.size() * numbers <= mostSizes) {
      EffectBlock block{.effect = e,
                        .owner = owner,
                        .sizes = SizesKind::PerOwner,
                        .sessions = everySession(owners.size()),
                        .features = MatrixXd::Zero(std::ssize(owners), std::ssize(groups)),
                        .logPrior = std::log(effectOdds())};
      for (std::size_t g = 0; g < groups.size(); ++g)
        for (const std::size_t s : groups[g].second)
          block.features(static_cast<Index>(s), static_cast<Index>(g)) = 1;
      blocks.push_back(std::move(block));
    }
    if (owners.size() > 1 && owners.size() * numbers <= mostSizes)
      blocks.push_back(
          {.effect = e,
           .owner = owner != CauseOwner::Time && groups.size() == owners.size() ? owner : CauseOwner::Time,
           .sizes = SizesKind::PerSession,
           .sessions = everySession(owners.size()),
           .features = MatrixXd::Identity(std::ssize(owners), std::ssize(owners)),
           .logPrior = std::log(owner == CauseOwner::Time || groups.size() == owners.size() ? effectOdds()
                                                                                            : differing)});
  }
  if (owners.size() > 1) addPatternBlocks(blocks, owners);
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
