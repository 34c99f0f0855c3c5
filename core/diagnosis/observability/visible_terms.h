#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/adjustment/joint/linearised.h"
#include "core/adjustment/numerics/prior.h"
#include "core/diagnosis/candidates/jump_moment.h"
#include "core/effects/catalogue.h"

namespace alidade {

// What readings would show of every error term, known by inner products alone. Normal equations add: each
// set of readings has arc angles and unknowns of its own, which are eliminated from its own equations; the
// error terms are common to all sets.
//
// Source: elimination of nuisance parameters by the Schur complement of the normal matrix.
struct VisibleTerms {
  Eigen::MatrixXd gram;   ///< of the visible parts of all ∂reading/∂term with one another, whitened
  Eigen::VectorXd whole;  ///< squared lengths of the columns before anything was eliminated
};

/// Of one set of readings, whose equations come in pieces of whole visits.
class VisibleTermsOfSet {
 public:
  /// Zero but for `terms`. Behind the terms the horizontal and the vertical step of a jump at each of
  /// `moments`, by which the set was differentiated then, rad.
  explicit VisibleTermsOfSet(std::vector<ErrorTerm> terms, std::vector<JumpMoment> moments = {})
      : m_terms(std::move(terms)), m_moments(std::move(moments)) {}

  void add(const Linearised& piece);
  /// With what is known beforehand of the unknowns; every piece was added.
  VisibleTerms sum() const;

 private:
  std::vector<ErrorTerm> m_terms;
  std::vector<JumpMoment> m_moments;
  std::vector<Prior> m_priors;  ///< of the unknowns that are not known exactly, common to all pieces
  Eigen::MatrixXd m_gram;       ///< of these unknowns, the terms and the jumps, outside the arc angles
};

/// Of a set in one piece.
VisibleTerms visibleTerms(const Linearised& set, const std::vector<ErrorTerm>& terms,
                          const std::vector<JumpMoment>& moments = {});
/// Of both sets together.
VisibleTerms operator+(const VisibleTerms& one, const VisibleTerms& other);
/// With some of the terms estimated along with the unknowns.
VisibleTerms withEstimated(VisibleTerms terms, const std::vector<EstimatedTerm>& estimated);

/// The columns of an effect, scaled to plausible sizes, as combinations of the terms: terms × parameters.
Eigen::MatrixXd combinationOf(const Effect& effect);

/// How far a combination of terms shows, σ.
double lengthOf(const VisibleTerms& terms, const Eigen::VectorXd& combination);

/// How far the nearest trace that an effect can leave, taken as linear, is from the trace of a combination
/// of terms, σ. `columns`: of the effect, as `combinationOf` has them. Of readings at hand
/// `Trace::differenceFrom` says the same, with the effect bent where it bends.
double linearDifferenceFrom(const VisibleTerms& terms, const Eigen::VectorXd& combination,
                            const Eigen::MatrixXd& columns, Response response);
double linearDifferenceFrom(const VisibleTerms& terms, const Eigen::VectorXd& combination,
                            const Effect& effect);

}  // namespace alidade
