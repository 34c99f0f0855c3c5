#pragma once

#include <QLineF>
#include <QPointF>
#include <cstddef>

#include "ui/charts/plotting/sighting_ref.h"

namespace alidade::ui {

/// A point of a plot, in the units of its axes.
struct Mark {
  QPointF at;
  std::size_t kind = 0;  ///< index into the layer's markers
  SightingRef ref;
  std::size_t index = 0;  ///< of what it shows, in the list of the plot's picture
  QPointF shift = {};     ///< off that place, in scene units, so that marks of one place stand apart
};

/// A straight piece in the units of the axes, such as a residual.
struct Stick {
  QLineF line;
  std::size_t kind = 0;  ///< index into the layer's pens
  QPointF shift = {};    ///< as of a mark
};

}  // namespace alidade::ui
