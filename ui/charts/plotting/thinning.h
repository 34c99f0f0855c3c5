#pragma once

#include <QRectF>
#include <QTransform>
#include <vector>

#include "ui/charts/plotting/mark.h"

namespace alidade::ui {

// Among a hundred thousand markers most are hidden under others. These functions choose the markers to paint,
// so that the cost of painting depends on the size of the plot, not on the number of readings. Extremes are
// always painted: the uppermost and lowest mark in each raster cell, and the longest sticks. Computations and
// pointing use all marks.

/// The frame of a plot in scene units, and the cell width of the raster: less than a marker.
struct Raster {
  QRectF area;
  double cell = 4;
};

/// A mark in scene units.
struct PlacedMark {
  QPointF at;
  std::size_t kind = 0;
};

/// The marks to paint in the area, in the given order: all if few, otherwise at most two per kind and cell.
std::vector<PlacedMark> thinned(const std::vector<Mark>& marks, const QTransform& sceneFromAxes,
                                const Raster& raster);

/// The sticks to paint, in scene units: all if few. Otherwise, for each cell, kind and eighth of a turn, the
/// longest stick that starts in the cell.
std::vector<Stick> thinned(const std::vector<Stick>& sticks, const QTransform& sceneFromAxes,
                           const Raster& raster);

}  // namespace alidade::ui
