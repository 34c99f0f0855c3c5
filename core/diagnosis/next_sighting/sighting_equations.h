#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "core/diagnosis/evidence/width.h"
#include "core/diagnosis/next_sighting/possible_sightings.h"
#include "core/effects/catalogue.h"

namespace alidade {

/// What may be the case, as columns of the equations. A weight of 1 is the plausible size.
struct MayBe {
  std::string_view cause;  ///< static text
  Eigen::Index first = 0, count = 0;
  const std::vector<Width>* widths = nullptr;  ///< of the normal prior of its weights; null: exactly 1
  double priorOdds = 0;                        ///< against nothing
  bool isBent = false;  ///< two weights, whose second derivatives follow (`bentWeights`)
};

/// One equation for each whitened direction of the readings that the arc angles leave.
struct SightingRows {
  Eigen::MatrixXd unknowns, causes;

  Eigen::Index rows() const { return unknowns.rows(); }
};

/// The linear equations of a session: of the sightings taken with their residuals, and of each that could be
/// next, given the others of its visit. Their errors are independent, of variance 1.
struct SightingEquations {
  SightingRows taken;
  Eigen::VectorXd residual;
  std::vector<SightingRows> possible;  ///< in the order of `PossibleSightings::possible`
  /// Proper normal priors of the unknowns, in the unit of each: residual = (prior − value)/σ.
  Eigen::VectorXd priorWeights, priorResiduals;
  Eigen::VectorXd intersection;  ///< ∂Δd/∂unknown
  double intersectionAt = 0;     ///< Δd at the point of linearisation, mm
  std::vector<MayBe> mayBe;
  double priorOdds = 0;            ///< of everything that may be the case, at any moment of the session
  Eigen::Index effectColumns = 0;  ///< the first columns belong to effects
};

/// Linearises at the circles that fit the sightings taken. With `effectsOnly` nothing else may be the case,
/// which suffices for U and is faster.
SightingEquations sightingEquations(const Measurement& taken, const SightingPlan& plan,
                                    PossibleSightings& session, bool effectsOnly = false);

/// Of the unknowns by the sightings taken and the priors.
struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};
NormalEquations normalEquationsOf(const SightingEquations& equations);

/// The equations that an arc angle leaves of the rows of one visit: an orthonormal basis of the complement of
/// `along`. All rows if `along` is zero.
Eigen::MatrixXd withoutArcAngle(const Eigen::MatrixXd& rows, const Eigen::VectorXd& along);

/// The equations that further rows of a visit add to those taken: what the arc angle from the rows taken
/// leaves of them, whitened.
Eigen::MatrixXd givenTheVisit(const Eigen::MatrixXd& further, const Eigen::VectorXd& alongFurther,
                              const Eigen::MatrixXd& taken, const Eigen::VectorXd& alongTaken);

}  // namespace alidade
