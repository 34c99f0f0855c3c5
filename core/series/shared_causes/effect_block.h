#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "core/diagnosis/session_evidence.h"
#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade {

/// Whose a session is.
struct SessionOwners {
  std::string instrument, guideway;  ///< serials; empty: nobody else's
  double time = 0;                   ///< 0…1 from the first session to the last
};

/// How the sizes of an effect in several sessions hang together: in session s they are Σⱼ Fₛⱼ zⱼ, with z
/// normal around zero and all of one width.
enum class SizesKind {
  One,         ///< F = 1
  PerOwner,    ///< each instrument, or each guideway, has its own
  PerSession,  ///< each session has its own
  Drifting,    ///< a random walk beside the one size: its first sines (Karhunen and Loève)
};

/// An effect, or a pattern of no catalogue, in the sessions of an owner.
struct EffectBlock {
  std::size_t effect = 0;  ///< index into `sharedColumns()`
  CauseOwner owner = CauseOwner::Time;
  SizesKind sizes = SizesKind::One;
  std::string serial = {};                 ///< with One
  std::vector<std::size_t> sessions = {};  ///< ascending
  Eigen::MatrixXd features = {};           ///< F, a row for each session; empty: one column of ones
  double logPrior = 0;                     ///< odds against nothing, natural

  const EffectColumns& columns() const { return sharedColumns()[effect]; }
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

/// Every effect with every owner it may have, and each with sizes of its own in each owner or session where
/// these are few; then every pattern with an owner that has several sessions.
std::vector<EffectBlock> effectBlocks(const std::vector<SessionOwners>& owners,
                                      const std::vector<std::string>& leftOut);

/// The same with a size that changes with time; absent (no sessions) where too few sessions would show it.
EffectBlock drifting(const EffectBlock& block, const std::vector<SessionOwners>& owners);

/// Odds of an effect before anything is read, shared by its owners.
double effectOdds();

}  // namespace alidade
