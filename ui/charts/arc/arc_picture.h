#pragma once

#include <QRectF>
#include <optional>
#include <vector>

#include "core/observation/guideway.h"
#include "ui/charts/plotting/sighting_ref.h"
#include "ui/jobs/evaluation.h"

namespace alidade::ui {

/// One row of readings in the arc plane; mm in o0.
struct DrawnSighting {
  SightingRef ref;
  int axisDeg = 0;
  int point = 0, round = 1, face = 1;
  PlanePoint<double> sighted;                  ///< where the line of sight meets the arc plane
  std::optional<PlanePoint<double>> adjusted;  ///< the adjusted target on the arc; absent without a fit
  /// What the sighting leaves over, in the arc plane: sighted minus adjusted, less the effects estimated
  /// along.
  PlanePoint<double> residual{};
};

/// A fitted arc over the angles it was sighted at, φ in radians, first < last, one run of at most a turn.
struct DrawnArc {
  int axisDeg = 0;
  Circle circle;
  double firstAngle = 0, lastAngle = 0;
};

/// Half the distance of the centres across the axis, with its expanded uncertainty; mm.
struct DrawnIntersection {
  PlanePoint<double> upperCentre, lowerCentre;  ///< O1 (axis at 0°), O2 (axis at 180°)
  double value = 0, expanded = 0, coverage = 0.95;
};

/// What the arc chart shows, in numbers.
struct ArcPicture {
  std::vector<DrawnArc> arcs;
  std::vector<DrawnSighting> sightings;
  std::vector<DrawnSighting> excluded;  ///< rows left out by the user whose readings can be understood
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
