#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "core/adjustment/arc/arc_fault.h"
#include "core/adjustment/numerics/fit_status.h"
#include "core/base/result.h"
#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

/// A symmetric 3×3 matrix over (Δx, Δy, R), row by row, in mm².
using Covariance3 = std::array<std::array<double, 3>, 3>;

/// The residuals of one sighting: observed minus adjusted.
struct SightingResidual {
  std::size_t row = 0;  ///< index into the position's readings
  double arcAngle = 0;  ///< φ of the adjusted target, radians in (−π, π]
  Angle horizontal;     ///< v_a
  Angle vertical;       ///< v_e, up positive for either kind of vertical circle
  /// w = v/(s0 σ √r) of each circle, from the fit of the whole session. NaN if no other reading checks the
  /// reading, and for an arc fitted alone.
  double horizontalStandardised = std::numeric_limits<double>::quiet_NaN();
  double verticalStandardised = std::numeric_limits<double>::quiet_NaN();
};

/// One arc, fitted by the rigorous or by the published method.
struct ArcFit {
  std::size_t position = 0;  ///< index into the session's positions
  int axisDeg = 0;
  Circle circle;                            ///< y up
  std::vector<SightingResidual> residuals;  ///< in the order of the sightings
  /// Circle readings − visits − unknowns; 0 or less: the noise cannot be checked. In the fit of a session as
  /// `ArcResidualSum::degreesOfFreedom`.
  double degreesOfFreedom = 0;
  double chiSquare = 0;    ///< Σ (v/σ)² with the stated σ
  double residualRms = 0;  ///< arcseconds, over all angle readings of the arc
  Covariance3 cofactor{};  ///< covariance of (Δx, Δy, R) from the stated σ of the readings alone
  int iterations = 0;
  FitStatus status = FitStatus::Undetermined;
  int repeat = 1;  ///< as `ArcMeasurement::repeat`

  bool converged() const { return status == FitStatus::Converged; }
  double reducedChiSquare() const { return degreesOfFreedom > 0 ? chiSquare / degreesOfFreedom : 0; }
  /// 1σ of the radius, mm; scaled up if the readings scatter more than stated.
  double radiusSigma() const {
    return std::max(1.0, std::sqrt(reducedChiSquare())) * std::sqrt(cofactor[2][2]);
  }
};

struct ArcFitOptions {
  std::optional<Circle> start =
      {};  ///< empty: from the fast fit, or from Kåsa's fit if the fast fit is refused; without R0
  int maximumIterations = 200;  ///< of Levenberg-Marquardt, including rejected steps
  /// Converged when the next step of (Δx, Δy, R) is shorter than this many standard deviations of the result.
  /// 1e-9 is some 10⁻¹¹ mm on the usual arc, and a hundred times the rounding error of the step.
  double tolerance = 1e-9;
};

/// The rigorous fit of one arc: weighted orthogonal least squares on the angles.
///
/// Minimises Σ (a_i − a(P(φ_v)))²/σ_h² + (e_i − e(P(φ_v)))²/σ_v² over Δx, Δy, R and one arc angle φ_v for
/// each visit; the rows of one visit (same round and point) share it. Levenberg-Marquardt with the arc angles
/// eliminated visit by visit; derivatives by automatic differentiation. Errors in both circles are allowed
/// for: the residuals are those of readings, not of plane coordinates.
///
/// Fails if the readings determine no circle: fewer than three different places, places on a straight line,
/// or an arc whose sagitta is hidden by the stated noise.
Result<ArcFit, ArcFault> fitArc(const Measurement& measurement, const ArcMeasurement& arc,
                                const ArcFitOptions& options = {});

/// Fills residuals, their rms and χ² of `fit` from its circle, with vertical angles by `relation` instead of
/// the measurement's own.
void fillResiduals(ArcFit& fit, const Measurement& measurement, const ArcMeasurement& arc,
                   VerticalAngleRelation relation);

}  // namespace alidade
