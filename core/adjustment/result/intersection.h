#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/session/measurement.h"

namespace alidade {

/// Index of the first arc at this axis angle; absent where there is none.
std::optional<std::size_t> arcAt(const Measurement& measurement, int axisDeg);

/// How the readings scatter against what is stated.
struct NoiseScale {
  double factor = 1;            ///< s0 = √(χ²/f): what comes from the readings is scaled by it
  double degreesOfFreedom = 0;  ///< f behind the factor; infinite where the stated noise is taken as known
};

/// The stated noise is taken as known, factor 1, where there is no redundancy or χ² is unknown, and where the
/// scatter is so small (below its 0.1 % point) that it speaks against the readings' independence rather than
/// for their precision.
NoiseScale noiseScale(const JointFit& fit);
NoiseScale noiseScale(double chiSquare, int degreesOfFreedom);

enum class UncertaintySource { Readings, ModelEffects, PlausibleSizes, KnownRadius, PointingZeros, Distance };

/// A share of the standard uncertainty of a result.
struct BudgetEntry {
  UncertaintySource source = UncertaintySource::Readings;
  double sigma = 0;   ///< mm
  double scaled = 0;  ///< the part of it that is known by the scatter of the readings alone, mm
};

/// wᵀ Q e_u: the covariance of a linear combination of the unknowns (`weights`) with one of them.
double covarianceWith(const SquareMatrix& cofactor, const std::vector<double>& weights, std::size_t unknown);

/// The change of a linear combination of the unknowns by `JointFit::considered[index]`.
double ratePerConsidered(const JointFit& fit, const std::vector<double>& weights, std::size_t index);

/// The variance that what is known beforehand of one unknown brings to a linear combination of all
/// (`weights`): the gain of the adjustment on it times its σ, squared; 0 where nothing is known. `cofactor`:
/// of the fit, with or without its terms.
double varianceOfPrior(const JointFit& fit, const SquareMatrix& cofactor, const std::vector<double>& weights,
                       std::size_t unknown);

/// The budget of a linear combination of the unknowns (`weights`, one for each): the readings, and what
/// estimating error terms along costs on top, scaled by `scale`; what the readings do not tell of the terms,
/// by their plausible sizes (both listed only if there are any); the radius where it is known, the pointing
/// zeros, one for each position and independent, and the distance, common to both, as stated. Zeros of which
/// no σ is stated (`Measurement::zerosAreReadings`) scatter as the circles do, and never less than stated for
/// these.
std::vector<BudgetEntry> budgetOf(const JointFit& fit, const std::vector<double>& weights, double scale);

/// The covariance of two linear combinations of the unknowns, by their budgets: cov(a, b) = (var(a + b) −
/// var(a − b))/4.
double covarianceOf(const JointFit& fit, const std::vector<double>& one, const std::vector<double>& other,
                    double scale);

/// The root of the sum of squares.
double combined(std::span<const BudgetEntry> budget);
/// The same of what is known by the scatter alone.
double scaledPart(std::span<const BudgetEntry> budget);

/// Standard uncertainties of one arc's quantities, mm, and how the centre hangs on the radius.
struct ArcSigma {
  double x = 0, y = 0, radius = 0;
  /// Correlation of R with x and with y, −1…1. On half an arc a radius wrong by its σ takes the centre's
  /// height along by this share of that height's σ. 0 where R is exact.
  double radiusX = 0, radiusY = 0;
};

/// The budgets behind them, in the order of the sources of Δd's.
struct ArcBudget {
  std::vector<BudgetEntry> x, y, radius;
};

/// Of arc `arc` of the fitted measurement.
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
  double effectiveDegreesOfFreedom = 0;  ///< Welch-Satterthwaite; infinite where nothing was estimated
  double inPlane = 0;                    ///< |O1 − O2|/2
  double inPlaneSigma = 0, inPlaneExpanded = 0;
  std::vector<BudgetEntry> budget;
};

/// 1 for this unknown of the fit, 0 for the others.
std::vector<double> unitWeights(const JointFit& fit, const Unknown& unknown);

/// ∂Δd/∂unknown of a fit whose arcs `upper` and `lower` are those at 0° and at 180°.
std::vector<double> intersectionWeights(const JointFit& fit, std::size_t upper, std::size_t lower);

/// Absent unless `measurement`, which was fitted, holds arcs at 0° and at 180°, and the fit is determined.
std::optional<Intersection> intersect(const Measurement& measurement, const JointFit& fit);
/// `noise`: that of the fit.
std::optional<Intersection> intersect(const Measurement& measurement, const JointFit& fit,
                                      const NoiseScale& noise);

}  // namespace alidade
