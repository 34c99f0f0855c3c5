#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "core/diagnosis/evidence/width.h"
#include "core/diagnosis/next_sighting/possible_sightings.h"
#include "core/effects/catalogue.h"

namespace alidade {

/// A hypothesis as columns of the equations. A weight of 1 is the plausible size.
struct Hypothesis {
  std::string_view cause;  ///< static text
  Eigen::Index first = 0, count = 0;
  const std::vector<Width>* widths = nullptr;  ///< widths of the normal prior; null: the weight is exactly 1
  double priorOdds = 0;                        ///< prior odds against no cause; 0 if it counts in U only
  bool isBent = false;  ///< two weights, whose second derivatives follow (`bentWeights`)
};

/// One equation for each whitened combination of readings after elimination of the arc angles.
struct SightingRows {
  Eigen::MatrixXd unknowns, causes;
};

/// The linear equations of a session: of the sightings taken, with their residuals, and of each candidate for
/// the next sighting, given those taken in its visit. The errors are independent, of variance 1.
struct SightingEquations {
  SightingRows taken;
  Eigen::VectorXd residual;
  std::vector<SightingRows> possible;  ///< in the order of `PossibleSightings::possible`
  /// Proper normal priors of the unknowns, in the unit of each: weight 1/σ, residual (prior − value)/σ.
  Eigen::VectorXd priorWeights, priorResiduals;
  Eigen::VectorXd intersection;  ///< ∂Δd/∂unknown
  double intersectionAt = 0;     ///< Δd at the point of linearisation, mm
  std::vector<Hypothesis> hypotheses;
  double priorOdds = 0;            ///< sum over all hypotheses, those of rows still to come included
  Eigen::Index effectColumns = 0;  ///< number of columns of effects, which come first

  /// Appends `priors.size()` unknowns that do not change Δd. `priors` are their weights 1/σ.
  void appendPriors(const Eigen::VectorXd& priors);
};

/// Fills `session`, and linearises at the circles that fit the sightings taken. With `effectsOnly` the
/// effects are the only hypotheses, which suffices for U and is faster.
SightingEquations sightingEquations(const Measurement& taken, const SightingPlan& plan,
                                    PossibleSightings& session, bool effectsOnly = false);

/// The normal equations of the unknowns from the sightings taken and the priors.
struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};
NormalEquations normalEquationsOf(const SightingEquations& equations);

/// Projects the rows of one visit on an orthonormal basis of the complement of `along`, which eliminates the
/// arc angle. Returns all rows if `along` is zero.
Eigen::MatrixXd withoutArcAngle(const Eigen::MatrixXd& rows, const Eigen::VectorXd& along);

/// Returns the whitened equations that further rows of a visit add to those taken. Each is the difference of
/// a further row from its prediction; the prediction uses the arc angle from the rows taken.
Eigen::MatrixXd givenTheVisit(const Eigen::MatrixXd& further, const Eigen::VectorXd& alongFurther,
                              const Eigen::MatrixXd& taken, const Eigen::VectorXd& alongTaken);

}  // namespace alidade
