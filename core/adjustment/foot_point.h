#pragma once

#include <array>

#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: a circle is given and one visit was sighted. Which point of the circle did the slider most
// likely stand at, and how does what is left over hang on the circle? In units of the
// stated σ ("whitened"):
//
//   minimise |r(φ)|²,  r = ((a − a(P(φ)))/σ_h, (e − e(P(φ)))/σ_v)
//
// At the minimum r is perpendicular to ∂r/∂φ, so with the unit normal n of ∂r/∂φ the visit is worth one
// scalar condition, d = n·r, whose derivatives with respect to the circle are those with φ eliminated.

/// Weights of the angles: 1/σ, per radian.
struct Whitening {
  double horizontal = 0, vertical = 0;
};

struct FootPoint {
  double phi = 0;                  ///< radians
  Direction<double> adjusted;      ///< what a perfect instrument reads there, radians
  double distance = 0;             ///< d in σ
  std::array<double, 3> gradient;  ///< ∂(n · whitened model reading)/∂(Δx, Δy, R), 1/mm
};

/// Needs R > 0. Iterates to rounding error from the nearest point in the plane; always finite.
FootPoint footPoint(const Circle& circle, double distance, VerticalAngleRelation relation,
                    const Whitening& whitening, const Direction<double>& sighted);

}  // namespace alidade
