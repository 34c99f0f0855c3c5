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

// Searches the shared effects that explain the leftovers of a series' sessions. In the linear model with
// normal weights the evidence of a set of effects has a closed form in sums over the sessions. The own causes
// of each session (`SessionExplanation`) are chosen again for every set, so that one session's cause is not
// mistaken for a shared one.
//
// Source: as `explanation.h`; the sums are those of normal equations of independent observations.

/// An effect of a set with its weights.
struct SharedPart {
  EffectBlock block;
  double width = 1, logGain = 0;
  // The weights of the block's columns (those of the effect for each feature) are fixed + slope z.
  Eigen::VectorXd fixed = {};
  Eigen::MatrixXd slope = {};
  Eigen::VectorXd weights = {};  ///< fixed + slope z for the estimated z

  /// Weights in the session `block.sessions[index]`.
  EffectVector weightsIn(std::size_t index) const;
};

struct SharedSet {
  std::vector<SharedPart> parts = {};
  std::vector<std::size_t> explanations = {};  ///< of each session
  double logPosteriorOdds = 0;                 ///< natural log of the odds against no effect in any session
  double chance = 0;                           ///< posterior probability among the sets found, 0…1
  Eigen::MatrixXd covariance = {};             ///< of z of all parts, concatenated

  /// True if the set contains an uncatalogued pattern.
  bool isShaped() const {
    return std::ranges::any_of(parts, [](const SharedPart& part) { return part.block.isPattern(); });
  }
};

class SharedSearch {
 public:
  /// The arguments must outlive the search.
  SharedSearch(const std::vector<SessionSums>& sessions, const std::vector<EffectBlock>& blocks,
               const std::stop_token& stop)
      : m_sessions(sessions), m_blocks(blocks), m_stop(stop) {}

  /// The sets found, the likeliest first, without duplicates; includes the empty set.
  std::vector<SharedSet> grown() const;
  /// The set of exactly these blocks, added in this order; the search for explanations starts from
  /// `explanations`.
  SharedSet madeOf(const std::vector<EffectBlock>& blocks,
                   const std::vector<std::size_t>& explanations) const;
  /// The set of these blocks under exactly these explanations. `counts`: which sessions count; empty: all.
  SharedSet fitted(const std::vector<EffectBlock>& blocks, const std::vector<std::size_t>& explanations,
                   const std::function<bool(std::size_t)>& counts = {}) const;
  /// Log odds of each explanation of a session, given a set.
  std::vector<double> explanationOdds(std::size_t session, const SharedSet& set) const;
  std::vector<double> explanationChances(std::size_t session, const SharedSet& set) const;
  /// The gain of a block alone, without explanations.
  ColumnGain alone(const EffectBlock& block) const;
  /// Visible length of a part's weights, σ: in all its sessions, or in `part.block.sessions[index]`.
  double visibleLength(const SharedPart& part) const;
  double visibleLengthIn(const SharedPart& part, std::size_t index) const;
  /// The smallest difference between the part's trace and any trace of the block, σ.
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
  Sums sumsOf(const EffectBlock& block, const std::vector<std::size_t>& explanations,
              const Counts& counts) const;
  Eigen::MatrixXd across(const EffectBlock& a, const EffectBlock& b,
                         const std::vector<std::size_t>& explanations, const Counts& counts) const;
  struct GivenSet;
  GivenSet given(const SharedSet& set, const Eigen::MatrixXd& posterior, const EffectBlock& block,
                 const std::vector<std::size_t>& explanations, const Counts& counts) const;
  void take(SharedSet& set, const EffectBlock& block, const Counts& counts) const;
  std::vector<std::size_t> likeliestExplanations(const SharedSet& set, bool withPatterns) const;
  std::vector<Growth> promising(const SharedSet& set) const;
  double oddsOfExplanations(const SharedSet& set) const;
  double ownOdds(std::size_t session, std::size_t explanation) const;
  bool mayTake(const SharedSet& set, const EffectBlock& block) const;
};

/// Normalises the chances of sets and puts the likeliest first.
void normalise(std::vector<SharedSet>& sets);

}  // namespace alidade
