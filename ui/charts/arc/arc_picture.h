#pragma once

#include <QRectF>
#include <memory>
#include <optional>
#include <vector>

#include "core/evaluation/evaluation.h"
#include "core/observation/guideway.h"
#include "ui/charts/plotting/row_choice.h"
#include "ui/charts/plotting/sighting_ref.h"

namespace alidade::ui {

/// One row of readings in the arc plane; mm in o0.
struct DrawnSighting {
  SightingRef ref;
  int axisDeg = 0;
  int repeat = 1;  ///< number of the repeat at this axis
  int point = 0, round = 1, face = 1;
  PlanePoint<double> sighted;                  ///< intersection of the line of sight with the arc plane
  std::optional<PlanePoint<double>> adjusted;  ///< the adjusted target on the arc; absent without a fit
  /// The residual, mm: from the point of the adjusted angles, with estimated effects, to `sighted`.
  PlanePoint<double> residual{};
};

/// The fitted arc of an axis over the sighted angles φ of all its positions: one range of at most a turn,
/// radians, first < last.
struct DrawnArc {
  int axisDeg = 0;
  Circle circle;
  double firstAngle = 0, lastAngle = 0;
};

/// The coverage ellipse of a centre; mm, y up.
struct DrawnEllipse {
  double major = 0, minor = 0;  ///< semi-axes, ≥ 0; infinite if no ellipse is wide enough
  double direction = 0;         ///< direction of the major axis, from x towards y, radians

  /// Half the width and half the height of the bounding box.
  PlanePoint<double> reach() const;
};

/// The ellipse of a point with these variances and this covariance, mm²; a semi-axis is `scale` σ long.
DrawnEllipse ellipseOf(double varianceX, double varianceY, double covariance, double scale);

/// The semi-axis in σ of an ellipse that contains a point with probability `coverage`: the root of twice
/// Fisher's quantile, √5.99 at 95 % with known variance. `degreesOfFreedom`: effective, may be infinite.
double ellipseFactor(double coverage, double degreesOfFreedom);

/// Δd, half the difference of the centres in y, with its expanded uncertainty; mm.
struct DrawnIntersection {
  PlanePoint<double> upperCentre, lowerCentre;  ///< O1 (axis at 0°), O2 (axis at 180°)
  double value = 0, expanded = 0, coverage = 0.95;
  DrawnEllipse upperEllipse = {}, lowerEllipse = {};
  std::optional<double> tolerance = {};  ///< permitted distance of O1 and O2 from the axis

  /// O2 at closure: half a turn about an axis along x preserves x, so this point has the x of O1.
  PlanePoint<double> closedCentre() const { return {upperCentre.x, lowerCentre.y}; }
};

/// The contents of the arc chart, as numbers.
struct ArcPicture {
  std::vector<DrawnArc> arcs;  ///< one for each axis
  std::vector<DrawnSighting> sightings;
  std::vector<DrawnSighting> excluded;  ///< valid rows excluded by the user
  RowKinds kinds;                       ///< rounds and faces of all sightings
  std::optional<DrawnIntersection> intersection;
  double exaggeration =
      1;  ///< factor 1, 2, 5, 10, … by which residuals are enlarged, to at most 16 % of the radius

  bool isEmpty() const { return arcs.empty() && sightings.empty() && excluded.empty(); }
  /// The end of a sighting's exaggerated residual, mm in o0.
  PlanePoint<double> residualEnd(const DrawnSighting& sighting) const;
  /// Everything that must be visible, mm in o0; far outliers are excluded.
  QRectF extent() const;
};

ArcPicture arcPicture(const Evaluation& evaluation);

/// The picture computed along with the evaluation, or else a new one.
std::shared_ptr<const ArcPicture> arcPictureOf(const Evaluation& evaluation);

}  // namespace alidade::ui
