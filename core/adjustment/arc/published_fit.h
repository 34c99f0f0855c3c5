#pragma once

#include "core/adjustment/arc/arc_fit.h"

namespace alidade {

/// The paper's own quantities, in its own frame: with zenith angles its y points down.
struct AsPrinted {
  double deltaRadius = 0;         ///< ΔR of the second iteration alone, mm
  double x = 0, y = 0;            ///< Δx, Δy, mm
  double thetaX = 0, thetaY = 0;  ///< Δθx, Δθy, rad; a wrong sign makes the tilts third harmonics
};

struct PublishedFit {
  ArcFit arc;  ///< the circle in o0 (y up); residuals against that circle under the planar relation
  AsPrinted asPrinted;
};

/// The published method, to its printed digits. With x_i = L tan a_i and y_i = L tan(β_i − β0) fixed at their
/// start values,
///
///   R0² − x_i² − y_i² = [−2R0, −2x_i, −2y_i, 2y_i² tan b − 2x_i y_i tan a, 2x_i² tan a − 2x_i y_i tan b] ·
///                       [ΔR, Δx, Δy, Δθx, Δθy]ᵀ
///
/// is solved by least squares and R0 ← R0 + ΔR, exactly two times; converged if the last ΔR is below 0.0001
/// mm. (The paper prints +2y_i in rows 2..n: a misprint.) For comparison only. It assumes that the vertical
/// circle reads y/L, which no theodolite does, and is wrong by millimetres on this arc. Source: equations
/// (2)-(9) of Cui, Ren, Yuan, Liu, "Intersection Measurement for Rotatable Arc Guideway System". The method
/// states no covariance; it stays zero. Needs five different places.
Result<PublishedFit, ArcFault> fitArcAsPublished(const Measurement& measurement, const ArcMeasurement& arc);

}  // namespace alidade
