#pragma once

#include <optional>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// How probably a measurand lies within its tolerance, 0…1, by what is believed of it (JCGM 106:2012, 7.4).
// Absent without degrees of freedom or an uncertainty.

/// |Δd + shift| ≤ `tolerance`, mm.
std::optional<double> conformanceOf(const IntersectionEstimate& estimate, double tolerance, double shift = 0);

/// How probably Δd lies beyond a tolerance on either side, 0…1.
struct TailRisk {
  double below = 0;  ///< P(Δd < −tolerance)
  double above = 0;  ///< P(Δd > tolerance)

  bool areAtMost(double risk) const { return below <= risk && above <= risk; }
};

/// Of |Δd| against `tolerance`, mm. Absent as above.
std::optional<TailRisk> tailRiskOf(const IntersectionEstimate& estimate, double tolerance);

/// What is believed of Δd where something else adds `sigma` (≥ 0, mm) to its standard uncertainty, whichever
/// account is right.
IntersectionEstimate widened(IntersectionEstimate estimate, double sigma);

/// √(Δd² + Δz²) ≤ `tolerance`, mm, Δz as uncertain as Student's variable and independent of Δd.
std::optional<double> conformanceOf(const IntersectionEstimate& inPlane, const MeasuredLength& across,
                                    double tolerance);

/// The greatest probability, 0…1, that a guarded verdict (`decide`) at this tolerance (mm, > 0) is wrong:
/// that |Δd| is beyond it though accepted at its very edge, |Δd| + U = tolerance, or within it though
/// rejected at |Δd| − U = tolerance. What is believed of Δd is as wide and as skew there as in `estimate`; (1
/// − coverage)/2 where it is symmetric and U far below the tolerance. Absent where U has no end.
///
/// Source: JCGM 106:2012, 8.3, decision rules based on guard bands; ILAC-G8:09/2019, 4.2, w = U.
std::optional<double> greatestRisk(const IntersectionEstimate& estimate, double tolerance);

}  // namespace alidade
