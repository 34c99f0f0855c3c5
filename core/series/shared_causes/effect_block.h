#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "core/diagnosis/session_evidence.h"
#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade {

/// The owners of a session.
struct SessionOwners {
  std::string instrument, guideway;  ///< serial numbers; without one, the session has its own owner
  double time = 0;                   ///< 0…1 from the first session to the last
  const OwnEffects* own = nullptr;   ///< the user's own effects; null: none
};

/// The relation between the sizes of an effect in several sessions: in session s the size is Σⱼ Fₛⱼ zⱼ, where
/// all zⱼ are normal around zero with the same standard deviation.
enum class SizesKind {
  One,         ///< F = 1
  PerOwner,    ///< a size for each instrument, or for each guideway
  PerSession,  ///< a size for each session
  Drifting,    ///< one size plus a random walk of four sines (Karhunen–Loève)
};

/// An effect, or an uncatalogued pattern, in the sessions of an owner.
struct EffectBlock {
  const EffectColumns* effect = nullptr;
  CauseOwner owner = CauseOwner::Time;
  SizesKind sizes = SizesKind::One;
  std::string serial = {};                 ///< of the owner, if there is only one
  std::vector<std::size_t> sessions = {};  ///< ascending
  Eigen::MatrixXd features = {};           ///< F, a row for each session; empty: one column of ones
  double logPrior = 0;                     ///< natural log of the odds against no effect

  const EffectColumns& columns() const { return *effect; }
  bool isPattern() const { return columns().isPattern; }
  Eigen::Index rank() const { return features.size() > 0 ? features.cols() : 1; }
  Eigen::RowVectorXd featuresOf(std::size_t index) const {
    return features.size() > 0 ? Eigen::RowVectorXd(features.row(static_cast<Eigen::Index>(index)))
                               : Eigen::RowVectorXd(Eigen::RowVectorXd::Ones(1));
  }
  bool isSame(const EffectBlock& other) const {
    return effect == other.effect && owner == other.owner && sizes == other.sizes && serial == other.serial;
  }
};

/// Every effect with every possible owner; if owners or sessions are few, also with a size for each of them.
/// Then every pattern, for time and for each owner with at least three sessions. An effect of the user's own
/// is only in sessions that have it. The columns must outlive the blocks.
std::vector<EffectBlock> effectBlocks(const SharedColumns& columns, const std::vector<SessionOwners>& owners,
                                      const std::vector<std::string>& leftOut);

/// The block with a drifting size; empty unless `block` is a linear effect of one size in ≥ 4 sessions.
EffectBlock drifting(const EffectBlock& block, const std::vector<SessionOwners>& owners);

/// Prior odds of an effect; its owners share them equally.
double effectOdds();

}  // namespace alidade
