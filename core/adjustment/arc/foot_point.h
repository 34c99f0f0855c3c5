#pragma once

#include <cmath>
#include <optional>

#include "core/adjustment/arc/foot_equations.h"

namespace alidade {

// The situation: a circle is given and one visit was read by a perfect instrument. Which point of the circle
// did the slider most likely stand at, and what do the readings made there hang on? In units of the stated σ
// ("whitened"):
//
//   minimise |r(φ)|²,  r = ((a − a(P(φ)))/σ_h, (e − e(P(φ)))/σ_v, and (s − s0 ∓ φ)/σ_s with a slider reading)
//
// Closed form: a residual comes from the tangents of reading and model, sine and cosine of φ are turned along
// with it, so that of all functions of an angle there are only the tangents, once for each visit.

/// What was read at one visit.
struct VisitReading {
  double tanA = 0, tanE = 0;     ///< of the mean of its rows
  double rows = 1;               ///< > 0
  std::optional<double> slider;  ///< rad

  VisitReading() = default;
  explicit VisitReading(const Direction<double>& mean, double rowCount = 1)
      : tanA(std::tan(mean.a)), tanE(std::tan(mean.e)), rows(rowCount) {}
};

/// Where the line of sight meets the arc plane, mm.
PlanePoint<double> sightedPoint(const ArcView& view, const VisitReading& visit);

struct FootPoint : Foot<double> {
  double phi = 0;  ///< radians
};

/// Needs R > 0. Iterates to rounding error from the nearest point in the plane, or from `start` that is near;
/// always finite.
FootPoint footPoint(const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit);
FootPoint footPoint(const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit,
                    FootPoint start);

}  // namespace alidade
