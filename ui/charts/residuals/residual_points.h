#pragma once

#include <QList>
#include <QPointF>
#include <cstdint>
#include <vector>

#include "ui/charts/residuals/residual_picture.h"

namespace alidade::ui {

/// The place of a picture's residual in the chart, in axis units.
struct ResidualPoint {
  QPointF at;
  std::uint32_t index = 0;  ///< index into the picture's residuals
};

/// The chosen residuals that have a place: an unchecked reading has no standardised residual. `choice.rows`:
/// among the picture's kinds.
std::vector<ResidualPoint> residualPoints(const ResidualPicture& picture, const ResidualChoice& choice);

/// The range of 95 of 100 values of each rank if `count` of them are normal: below at the left of x, above.
struct NormalEnvelope {
  QList<QPointF> lower, upper;  ///< from left to right, with equal x
};

/// Empty for fewer than two values.
NormalEnvelope normalEnvelope(std::size_t count);

}  // namespace alidade::ui
