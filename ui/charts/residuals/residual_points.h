#pragma once

#include <QList>
#include <QPointF>
#include <cstdint>
#include <vector>

#include "ui/charts/residuals/residual_picture.h"

namespace alidade::ui {

/// Where a residual of a picture stands in the chart, in the units of its axes.
struct ResidualPoint {
  QPointF at;
  std::uint32_t index = 0;  ///< of the picture's residuals
};

/// Those that are chosen and have a place: a reading that nothing checks has no standardised residual.
/// `choice.rows`: among the picture's kinds.
std::vector<ResidualPoint> residualPoints(const ResidualPicture& picture, const ResidualChoice& choice);

/// Where 95 of 100 values of each rank lie if `count` of them are normal: below at the left of x, above.
struct NormalEnvelope {
  QList<QPointF> lower, upper;  ///< from left to right, of the same x
};

/// Empty below two values.
NormalEnvelope normalEnvelope(std::size_t count);

}  // namespace alidade::ui
