#pragma once

#include <cmath>
#include <optional>

#include "core/observation/guideway.h"
#include "core/session/measurement.h"

namespace alidade {

// The situation: a circle is given and one visit was read by a perfect instrument. Which point of the circle
// did the slider most likely stand at, and what do the readings made there hang on? In units of the stated σ
// ("whitened"):
//
//   minimise |r(φ)|²,  r = ((a − a(P(φ)))/σ_h, (e − e(P(φ)))/σ_v, and (s − s0 ∓ φ)/σ_s with a slider reading)
//
// Closed form: a residual comes from the tangents of reading and model, sine and cosine of φ are turned along
// with it, so that of all functions of an angle there are only the tangents, once for each visit.

/// Weights of the readings: 1/σ, per radian.
struct Whitening {
  double horizontal = 0, vertical = 0, slider = 0;
};

/// What all visits of an arc have in common.
struct ArcView {
  double distance = 0;  ///< L > 0, mm
  VerticalAngleRelation relation = VerticalAngleRelation::Exact;
  Whitening whitening;
  double turn = 1;  ///< the slider reads s0 + turn · φ: 1 at axis 0°, −1 at 180°

  ArcView(const Measurement& measurement, int axisDeg);
};

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

/// A circle, and what the slider reads at φ = 0 (rad).
struct ArcUnknowns {
  Circle circle;
  double sliderZero = 0;
};

struct FootPoint {
  double phi = 0;               ///< radians
  double cosine = 1, sine = 0;  ///< of it
  Direction<double> left;       ///< mean of the readings less what a perfect instrument reads there, radians
  double sliderLeft = 0;        ///< the same of the slider reading, 0 without one
  /// ∂(a, e)/∂(x, y, L) at the foot, per mm; a does not hang on y.
  double aX = 0, aL = 0, eX = 0, eY = 0, eL = 0;
};

/// Needs R > 0. Iterates to rounding error from the nearest point in the plane, or from `start` that is near;
/// always finite.
FootPoint footPoint(const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit);
FootPoint footPoint(const ArcView& view, const ArcUnknowns& unknowns, const VisitReading& visit,
                    FootPoint start);

}  // namespace alidade
