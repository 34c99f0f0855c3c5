#pragma once

#include <optional>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// Probability, 0…1, that a measurand lies within its tolerance, from the distribution of its estimate (JCGM
// 106:2012, 7.4). Absent without degrees of freedom or an uncertainty.

/// The measurand is |Δd + shift|; `tolerance` and `shift` are in mm.
std::optional<double> conformanceOf(const IntersectionEstimate& estimate, double tolerance, double shift = 0);

/// Probability, 0…1, that Δd lies beyond the tolerance, for each side.
struct TailRisk {
  double below = 0;  ///< P(Δd < −tolerance)
  double above = 0;  ///< P(Δd > tolerance)

  bool areAtMost(double risk) const { return below <= risk && above <= risk; }
};

/// The measurand is |Δd|; `tolerance` is in mm. Absent without degrees of freedom or an uncertainty.
std::optional<TailRisk> tailRiskOf(const IntersectionEstimate& estimate, double tolerance);

/// Adds a further standard uncertainty `sigma` (≥ 0, mm) to every explanation of Δd.
IntersectionEstimate widened(IntersectionEstimate estimate, double sigma);

/// The measurand is √(Δd² + Δz²), mm. Δz follows Student's distribution, independent of Δd.
std::optional<double> conformanceOf(const IntersectionEstimate& inPlane, const MeasuredLength& across,
                                    double tolerance);

/// Returns the largest probability, 0…1, that a guarded verdict (`decide`) at this tolerance (mm, > 0) is
/// wrong. An acceptance at |Δd| + U = tolerance is wrong if the true |Δd| exceeds the tolerance. A rejection
/// at |Δd| − U = tolerance is wrong if the true |Δd| does not exceed it. The distribution of Δd has the width
/// and skewness of `estimate`. The result is (1 − coverage)/2 if this distribution is symmetric and U is far
/// below the tolerance. Absent if U is infinite.
///
/// Source: JCGM 106:2012, 8.3, decision rules based on guard bands; ILAC-G8:09/2019, 4.2, w = U.
std::optional<double> greatestRisk(const IntersectionEstimate& estimate, double tolerance);

}  // namespace alidade
