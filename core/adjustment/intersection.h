#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/arc_fit.h"

namespace alidade {

/// A share of the standard uncertainty of the intersection.
struct BudgetEntry {
  std::string source;  ///< "readings", "pointing zeros", "distance"
  double sigma = 0;    ///< mm
};

/// The intersection Δd = (Δy(0°) − Δy(180°))/2, y up, mm.
struct Intersection {
  double value = 0;
  double sigma = 0;           ///< combined standard uncertainty: the root of the sum of squares of the budget
  double expanded = 0;        ///< U = k σ at `coverage`
  double coverage = 0.95;     ///< in (0, 1)
  double coverageFactor = 0;  ///< k: Student's quantile at the effective degrees of freedom
  double effectiveDegreesOfFreedom = 0;  ///< Welch-Satterthwaite; infinite where nothing was estimated
  double inPlane = 0;                    ///< |O1 − O2|/2
  std::vector<BudgetEntry> budget;
};

/// Standard uncertainties of one arc's quantities, mm.
struct ArcSigma {
  double x = 0, y = 0, radius = 0;
};

/// How the readings scatter against what is stated.
struct NoiseScale {
  double factor = 1;  ///< s0 = √(Σχ²/Σf) over the arcs: what comes from the readings is scaled by it
  double degreesOfFreedom = 0;  ///< Σf behind the factor; infinite where the stated noise is taken as known
};

/// The stated noise is taken as known, factor 1, where no arc has redundancy, and where the scatter is so
/// small (below its 0.1 % point) that it speaks against the readings' independence rather than for their
/// precision.
NoiseScale noiseScale(const std::vector<ArcFit>& arcs);

/// Readings scaled by `scale`, pointing zero and distance as stated.
ArcSigma arcSigma(const Measurement& measurement, const ArcFit& arc, double scale);

/// From the arcs at 0° and 180°. The readings' share is scaled by the residuals of both arcs (s0); the
/// pointing zeros, one for each position and independent, and the distance, common to both, enter as stated.
/// Absent unless both arcs are there.
std::optional<Intersection> intersect(const Measurement& measurement, const std::vector<ArcFit>& arcs);

}  // namespace alidade
