#pragma once

#include <QRectF>
#include <optional>
#include <vector>

#include "core/observation/guideway.h"
#include "ui/charts/plotting/row_choice.h"
#include "ui/charts/plotting/sighting_ref.h"
#include "ui/jobs/evaluation.h"

namespace alidade::ui {

/// One row of readings in the arc plane; mm in o0.
struct DrawnSighting {
  SightingRef ref;
  int axisDeg = 0;
  int time = 1;  ///< the how many-th position at this axis
  int point = 0, round = 1, face = 1;
  PlanePoint<double> sighted;                  ///< where the line of sight meets the arc plane
  std::optional<PlanePoint<double>> adjusted;  ///< the adjusted target on the arc; absent without a fit
  /// What the sighting leaves over, in the arc plane: sighted minus adjusted, less the effects estimated
  /// along.
  PlanePoint<double> residual{};
};

/// The fitted arc of an axis over the angles it was sighted at, in all positions, φ in radians, first < last,
/// one run of at most a turn.
struct DrawnArc {
  int axisDeg = 0;
  Circle circle;
  double firstAngle = 0, lastAngle = 0;
};

/// Where a centre is believed to lie at the coverage; mm, y up.
struct DrawnEllipse {
  double major = 0, minor = 0;  ///< semi-axes, ≥ 0; not finite where no ellipse is wide enough
  double direction = 0;         ///< of the major one, from x towards y, radians

  /// Half the width and half the height of the box around it.
  PlanePoint<double> reach() const;
};

/// `varianceX`, `varianceY`, `covariance` of a point, mm²; `scale`: semi-axis in σ.
DrawnEllipse ellipseOf(double varianceX, double varianceY, double covariance, double scale);

/// Semi-axis of an ellipse in σ that holds a point with probability `coverage`: the root of twice Fisher's
/// quantile, √5.99 at 95 % where nothing was estimated. `degreesOfFreedom`: effective, may be infinite.
double ellipseFactor(double coverage, double degreesOfFreedom);

/// Half the distance of the centres across the axis, with its expanded uncertainty; mm.
struct DrawnIntersection {
  PlanePoint<double> upperCentre, lowerCentre;  ///< O1 (axis at 0°), O2 (axis at 180°)
  double value = 0, expanded = 0, coverage = 0.95;
  DrawnEllipse upperEllipse = {}, lowerEllipse = {};
  std::optional<double> tolerance = {};  ///< how far from the axis O1 and O2 may lie

  /// Half a turn about an axis along x leaves x alone: where O2 would lie at its height.
  PlanePoint<double> closedCentre() const { return {upperCentre.x, lowerCentre.y}; }
};

/// What the arc chart shows, in numbers.
struct ArcPicture {
  std::vector<DrawnArc> arcs;  ///< one for each axis
  std::vector<DrawnSighting> sightings;
  std::vector<DrawnSighting> excluded;  ///< rows left out by the user whose readings can be understood
  RowKinds kinds;                       ///< of all of them
  std::optional<DrawnIntersection> intersection;
  double exaggeration =
      1;  ///< of the residuals: 1, 2, 5, 10, … so that the largest is at most 16 % of the radius

  bool isEmpty() const { return arcs.empty() && sightings.empty() && excluded.empty(); }
  /// Where the exaggerated residual of a sighting ends.
  PlanePoint<double> residualEnd(const DrawnSighting& sighting) const;
  /// Everything that must be visible, mm in o0; far outliers are left outside.
  QRectF extent() const;
};

ArcPicture arcPicture(const Evaluation& evaluation);

}  // namespace alidade::ui
