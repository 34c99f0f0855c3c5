#pragma once

#include <QRectF>
#include <QTransform>
#include <vector>

#include "ui/charts/plotting/mark.h"

namespace alidade::ui {

// Of a hundred thousand markers most lie under others and are not seen. These functions choose those to be
// painted, so that painting costs by the size of the plot and not by the number of readings. What stands out
// is always among them, where it is: in each cell of a raster the uppermost and the lowest mark, and the
// longest sticks. Neither what is computed nor what is pointed at knows of it.

/// The frame of a plot in scene units, and how wide a cell of the raster is: less than a marker.
struct Raster {
  QRectF area;
  double cell = 4;
};

/// A mark in scene units.
struct PlacedMark {
  QPointF at;
  std::size_t kind = 0;
};

/// The marks in the area to paint, in the order given: all where they are few, otherwise of each kind at most
/// two in a cell.
std::vector<PlacedMark> thinned(const std::vector<Mark>& marks, const QTransform& sceneFromAxes,
                                const Raster& raster);

/// The sticks to paint, in scene units: all where they are few, otherwise of each kind and eighth of a turn
/// the longest that starts in a cell.
std::vector<Stick> thinned(const std::vector<Stick>& sticks, const QTransform& sceneFromAxes,
                           const Raster& raster);

}  // namespace alidade::ui
