#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/session/measurement.h"

namespace alidade {

/// Index of the first arc at this axis angle; absent if there is none.
std::optional<std::size_t> arcAt(const Measurement& measurement, int axisDeg);

/// The scatter of the readings compared with the stated noise.
struct NoiseScale {
  double factor = 1;            ///< s0 = √(χ²/f), which scales the contribution of the readings
  double degreesOfFreedom = 0;  ///< f of the factor; infinite if the stated noise is known
};

/// The stated noise counts as known, with factor 1, if there is no redundancy or χ² is unknown. The same
/// holds if χ² is below its 0.1 % point, which indicates dependent readings rather than precision.
NoiseScale noiseScale(const JointFit& fit);
NoiseScale noiseScale(double chiSquare, int degreesOfFreedom);

enum class UncertaintySource { Readings, ModelEffects, PlausibleSizes, KnownRadius, PointingZeros, Distance };

/// A share of the standard uncertainty of a result.
struct BudgetEntry {
  UncertaintySource source = UncertaintySource::Readings;
  double sigma = 0;   ///< mm
  double scaled = 0;  ///< its part known only from the scatter of the readings, mm
};

/// wᵀ Q e_u: the covariance of a linear combination of the unknowns (`weights`) with one of them.
double covarianceWith(const SquareMatrix& cofactor, const std::vector<double>& weights, std::size_t unknown);

/// The derivative of a linear combination of the unknowns with respect to `JointFit::considered[index]`.
double ratePerConsidered(const JointFit& fit, const std::vector<double>& weights, std::size_t index);

/// The variance that the prior of one unknown contributes to a linear combination of all (`weights`): the
/// gain of the adjustment times its σ, squared; 0 without prior knowledge. `cofactor`: of the fit, with or
/// without its terms.
double varianceOfPrior(const JointFit& fit, const SquareMatrix& cofactor, const std::vector<double>& weights,
                       std::size_t unknown);

/// The budget of a linear combination of the unknowns (`weights`, one for each). Scaled by `scale`: the
/// readings, and the additional cost of estimating error terms. Not scaled: the prior contribution of the
/// terms by their plausible sizes (both listed only if there are terms); the radius if known; the pointing
/// zeros, one for each position and independent; the distance, common to both, as stated. Zeros without a
/// stated σ (`Measurement::zerosAreReadings`) scatter like the circles, at least with the circles' stated σ.
std::vector<BudgetEntry> budgetOf(const JointFit& fit, const std::vector<double>& weights, double scale);

/// The covariance of two linear combinations of the unknowns, from their budgets: cov(a, b) = (var(a + b) −
/// var(a − b))/4.
double covarianceOf(const JointFit& fit, const std::vector<double>& one, const std::vector<double>& other,
                    double scale);

/// The root of the sum of squares.
double combined(std::span<const BudgetEntry> budget);
/// The root of the sum of squares of the scaled parts.
double scaledPart(std::span<const BudgetEntry> budget);

/// Standard uncertainties of one arc's quantities, mm, and how the centre depends on the radius.
struct ArcSigma {
  double x = 0, y = 0, radius = 0;
  /// Correlation of R with x and with y, −1…1. If R is wrong by its σ, the coordinate is on average wrong by
  /// this share of its own σ. 0 if R is exact.
  double radiusX = 0, radiusY = 0;
};

/// The budgets of the arc's quantities, with sources in the same order as in the budget of Δd.
struct ArcBudget {
  std::vector<BudgetEntry> x, y, radius;
};

/// Returns the budget of arc `arc` of the fitted measurement.
ArcBudget arcBudget(const JointFit& fit, std::size_t arc, double scale);
ArcSigma arcSigma(const JointFit& fit, std::size_t arc, double scale);
/// `budget`: that of `arcBudget`.
ArcSigma arcSigma(const JointFit& fit, std::size_t arc, double scale, const ArcBudget& budget);

/// The intersection Δd = (Δy(0°) − Δy(180°))/2, y up, mm.
struct Intersection {
  double value = 0;
  double sigma = 0;                      ///< combined standard uncertainty
  double expanded = 0;                   ///< U = k σ at `coverage`
  double coverage = 0.95;                ///< in (0, 1)
  double coverageFactor = 0;             ///< k: Student's quantile at the effective degrees of freedom
  double effectiveDegreesOfFreedom = 0;  ///< Welch-Satterthwaite; infinite if no σ was estimated
  double inPlane = 0;                    ///< |O1 − O2|/2
  double inPlaneSigma = 0, inPlaneExpanded = 0;
  std::vector<BudgetEntry> budget;
};

/// 1 for this unknown of the fit, 0 for the others.
std::vector<double> unitWeights(const JointFit& fit, const Unknown& unknown);

/// ∂Δd/∂unknown of a fit whose arcs `upper` and `lower` are those at 0° and at 180°.
std::vector<double> intersectionWeights(const JointFit& fit, std::size_t upper, std::size_t lower);

/// Absent unless the fitted `measurement` has arcs at 0° and at 180° and the fit is determined.
std::optional<Intersection> intersect(const Measurement& measurement, const JointFit& fit);
/// `noise`: that of the fit.
std::optional<Intersection> intersect(const Measurement& measurement, const JointFit& fit,
                                      const NoiseScale& noise);

}  // namespace alidade
