#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/adjustment/joint/linearised.h"
#include "core/adjustment/numerics/prior.h"
#include "core/diagnosis/candidates/jump_moment.h"
#include "core/effects/catalogue.h"

namespace alidade {

// The visible traces of all error terms, as inner products. Normal equations add up: each set of readings has
// its own arc angles and unknowns, which are eliminated from its own equations. The error terms are common to
// all sets.
//
// Source: elimination of nuisance parameters by the Schur complement of the normal matrix.
struct VisibleTerms {
  Eigen::MatrixXd gram;   ///< Gram matrix of the visible parts of all ∂reading/∂term, whitened
  Eigen::VectorXd whole;  ///< squared lengths of the columns before elimination
};

/// Sums up one set of readings, whose equations come in pieces of whole visits.
class VisibleTermsOfSet {
 public:
  /// Only the entries of `terms` are nonzero in the sum. Entries for the horizontal and vertical part of a
  /// jump (rad) at each of `moments` follow. The set must contain the derivatives by both parts.
  explicit VisibleTermsOfSet(std::vector<ErrorTerm> terms, std::vector<JumpMoment> moments = {})
      : m_terms(std::move(terms)), m_moments(std::move(moments)) {}

  void add(const Linearised& piece);
  /// Returns the sum of all pieces, with the prior knowledge of the unknowns.
  VisibleTerms sum() const;

 private:
  std::vector<ErrorTerm> m_terms;
  std::vector<JumpMoment> m_moments;
  std::vector<Prior> m_priors;  ///< priors of the uncertain unknowns, common to all pieces
  Eigen::MatrixXd m_gram;       ///< Gram matrix of uncertain unknowns, terms and jumps, arc angles eliminated
};

/// Computes the visible terms of a set in one piece.
VisibleTerms visibleTerms(const Linearised& set, const std::vector<ErrorTerm>& terms,
                          const std::vector<JumpMoment>& moments = {});
/// Returns the visible terms of both sets together.
VisibleTerms operator+(const VisibleTerms& one, const VisibleTerms& other);
/// Returns the visible terms with some terms treated as unknowns.
VisibleTerms withEstimated(VisibleTerms terms, const std::vector<EstimatedTerm>& estimated);

/// Returns the columns of an effect, scaled to plausible sizes, as combinations of the terms: terms ×
/// parameters.
Eigen::MatrixXd combinationOf(const Effect& effect);

/// Returns the length of the visible trace of a combination of terms, σ.
double lengthOf(const VisibleTerms& terms, const Eigen::VectorXd& combination);

/// Returns the distance from the trace of a combination of terms to the nearest linear trace of an effect, σ.
/// `columns` are those of the effect, from `combinationOf`. For existing readings, `Trace::differenceFrom`
/// gives the same distance, second order included.
double linearDifferenceFrom(const VisibleTerms& terms, const Eigen::VectorXd& combination,
                            const Eigen::MatrixXd& columns, Response response);
double linearDifferenceFrom(const VisibleTerms& terms, const Eigen::VectorXd& combination,
                            const Effect& effect);

}  // namespace alidade
