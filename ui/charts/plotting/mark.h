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
  std::size_t index = 0;  ///< index in the list of the plot's picture
  QPointF shift = {};     ///< shift in scene units, which separates marks of one place
};

/// A straight piece in the units of the axes, such as a residual.
struct Stick {
  QLineF line;
  std::size_t kind = 0;  ///< index into the layer's pens
  QPointF shift = {};    ///< shift in scene units
};

}  // namespace alidade::ui
