#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/series/shared_causes/effect_block.h"
#include "core/series/shared_causes/session_sums.h"

namespace alidade {

// Which shared effects explain what the sessions of a series leave over. In the linear model with normal
// weights the evidence of a set of effects has a closed form in sums over the sessions; what each session
// holds by itself (`OwnAccount`) is chosen anew beside every set, so that what one session suffers from does
// not pass for what all share.
//
// Source: as `explanation.h`; the sums are those of normal equations of independent observations.

/// An effect of a set with the weights it takes.
struct SharedPart {
  EffectBlock block;
  double width = 1, logGain = 0;
  // The block's columns (those of the effect for each feature) take the weights fixed + slope z.
  Eigen::VectorXd fixed = {};
  Eigen::MatrixXd slope = {};
  Eigen::VectorXd weights = {};  ///< so taken

  /// In the index-th of its sessions.
  EffectVector weightsIn(std::size_t index) const;
};

struct SharedSet {
  std::vector<SharedPart> parts = {};
  std::vector<std::size_t> accounts = {};  ///< of each session
  double logPosteriorOdds = 0;             ///< against nothing in any session, natural
  double chance = 0;                       ///< 0…1, of those found
  Eigen::MatrixXd covariance = {};         ///< of z of all parts, one after the other

  /// Holds a pattern of no catalogue.
  bool isShaped() const {
    return std::ranges::any_of(parts, [](const SharedPart& part) { return part.block.isPattern(); });
  }
};

class SharedSearch {
 public:
  /// All have to live as long.
  SharedSearch(const std::vector<SessionSums>& sessions, const std::vector<EffectBlock>& blocks,
               const std::stop_token& stop)
      : m_sessions(sessions), m_blocks(blocks), m_stop(stop) {}

  /// The likeliest first; always holds the set of nothing. Each set once.
  std::vector<SharedSet> grown() const;
  /// Exactly these, each as it is beside those before it; sessions start from these accounts.
  SharedSet madeOf(const std::vector<EffectBlock>& blocks, const std::vector<std::size_t>& accounts) const;
  /// Sizes under these very accounts. `sessions`: those that count; empty: all.
  SharedSet fitted(const std::vector<EffectBlock>& blocks, const std::vector<std::size_t>& accounts,
                   const std::function<bool(std::size_t)>& counts = {}) const;
  /// What an account of a session comes to beside a set, and the chance of each.
  std::vector<double> accountOdds(std::size_t session, const SharedSet& set) const;
  std::vector<double> accountChances(std::size_t session, const SharedSet& set) const;
  /// What a block alone adds under no account.
  ColumnGain alone(const EffectBlock& block) const;
  /// Visible length of a part's weights, σ, of all its sessions, or in the index-th.
  double visibleLength(const SharedPart& part) const;
  double visibleLengthIn(const SharedPart& part, std::size_t index) const;
  /// How near the block can come to what a part leaves, σ.
  double differenceFrom(const SharedPart& part, const EffectBlock& block) const;

 private:
  const std::vector<SessionSums>& m_sessions;
  const std::vector<EffectBlock>& m_blocks;
  const std::stop_token& m_stop;

  struct Growth {
    std::size_t block;
    double log;
  };
  using Counts = std::function<bool(std::size_t)>;
  struct Sums {
    Eigen::MatrixXd normal;
    Eigen::VectorXd right;
  };
  Sums sumsOf(const EffectBlock& block, const std::vector<std::size_t>& accounts, const Counts& counts) const;
  Eigen::MatrixXd across(const EffectBlock& a, const EffectBlock& b, const std::vector<std::size_t>& accounts,
                         const Counts& counts) const;
  struct Beside;
  Beside beside(const SharedSet& set, const Eigen::MatrixXd& posterior, const EffectBlock& block,
                const std::vector<std::size_t>& accounts, const Counts& counts) const;
  void take(SharedSet& set, const EffectBlock& block, const Counts& counts) const;
  std::vector<std::size_t> likeliestAccounts(const SharedSet& set, bool withPatterns) const;
  std::vector<Growth> promising(const SharedSet& set) const;
  double accountsOf(const SharedSet& set) const;
  double ownOdds(std::size_t session, std::size_t account) const;
  bool mayTake(const SharedSet& set, const EffectBlock& block) const;
};

/// Normalises the chances of sets and puts the likeliest first.
void normalise(std::vector<SharedSet>& sets);

}  // namespace alidade
