#pragma once

#include <cmath>
#include <optional>

#include "core/adjustment/arc/foot_equations.h"

namespace alidade {

// The situation: a circle is given and one visit was read by a perfect instrument. At which point of the
// circle was the slider most likely, and how do the readings depend on the circle there? In units of the
// stated σ ("whitened"):
//
//   minimise |r(φ)|², r = ((a − a(P(φ)))/σ_h, (e − e(P(φ)))/σ_v, and (s − s0 ∓ φ)/σ_s with a slider reading)
//
// The residuals are closed forms in the tangents of reading and model; sine and cosine of φ are rotated with
// each step. The tangents are the only functions of an angle, computed once for each visit.

/// The readings of one visit.
struct VisitReading {
  double tanA = 0, tanE = 0;     ///< of the mean of its rows
  double rows = 1;               ///< > 0
  std::optional<double> slider;  ///< rad

  VisitReading() = default;
  explicit VisitReading(const Direction<double>& mean, double rowCount = 1)
      : tanA(std::tan(mean.a)), tanE(std::tan(mean.e)), rows(rowCount) {}
};

/// Intersection of the line of sight with the arc plane, mm.
PlanePoint<double> sightedPoint(const ArcView& view, const VisitReading& visit);

struct FootPoint : Foot<double> {
  double phi = 0;  ///< radians
};

/// Minimises |r(φ)|² by iteration to rounding error, from the circle's point nearest to the sighted point, or
/// from a nearby `start`. Needs R > 0. The result is always finite.
FootPoint footPoint(const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit);
FootPoint footPoint(const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit,
                    FootPoint start);

}  // namespace alidade
