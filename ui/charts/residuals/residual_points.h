#pragma once

#include <QList>
#include <QPointF>
#include <cstdint>
#include <vector>

#include "core/base/histogram.h"
#include "ui/charts/residuals/residual_picture.h"

namespace alidade::ui {

/// The place of a picture's residual in the chart, in axis units.
struct ResidualPoint {
  QPointF at;
  std::uint32_t index = 0;  ///< index into the picture's residuals
};

/// The places of the chosen residuals; standardised residuals of unchecked readings have no value and no
/// place. In a histogram all are at y = 0. `choice.rows` must name only rounds and faces of the picture.
std::vector<ResidualPoint> residualPoints(const ResidualPicture& picture, const ResidualChoice& choice);

/// The histogram of residuals, as drawn.
struct ResidualClasses {
  Histogram histogram;
  std::vector<NormalValues> normal;  ///< the stated noise: one for each circle
  QList<QPointF> outline;            ///< of the bars, from left to right
  QList<QPointF> curve;  ///< at x the expected number of normal values in a class whose middle is x

  double expected(std::size_t index) const;
};

/// Counts residuals of `choice` in classes over ±`reach` and places each in the bar of its class, above the
/// residuals counted before. A residual in no class stays at y = 0.
ResidualClasses stackInClasses(std::vector<ResidualPoint>& points, const ResidualPicture& picture,
                               const ResidualChoice& choice, double reach);

/// For each rank, the range that contains its value with a probability of 95 % if all values are normal.
struct NormalEnvelope {
  QList<QPointF> lower, upper;  ///< ends of the range, from left to right, with equal x
};

/// Empty for fewer than two values.
NormalEnvelope normalEnvelope(std::size_t count);

}  // namespace alidade::ui
