#include "ui/charts/residuals/residual_kinds.h"

#include "ui/text/position_text.h"

namespace alidade::ui {
namespace {

MarkerShape shapeOf(CircleRead circle) {
  if (circle == CircleRead::Slider) return MarkerShape::Square;
  return circle == CircleRead::Horizontal ? MarkerShape::Circle : MarkerShape::Diamond;
}

}  // namespace

Marker ResidualKind::marker(const PlotStyle& style) const {
  Marker marker = style.marker(axisDeg, shapeOf(circle), isAgain ? 2 : 1);
  marker.struck = isFaceTwo;
  return marker;
}

QString ResidualKind::text() const {
  return positionText(axisDeg, isAgain ? 2 : 1) + u' ' + circleName(circle);
}

std::size_t ResidualKinds::take(const DrawnResidual& residual) {
  const ResidualKind kind{residual.axisDeg, residual.repeat > 1, residual.circle, residual.face == 2};
  const std::size_t at = (((kind.axisDeg == 0 ? 0U : 1U) * 2 + (kind.isAgain ? 1U : 0U)) * 3 +
                          static_cast<std::size_t>(kind.circle)) *
                             2 +
                         (kind.isFaceTwo ? 1U : 0U);
  if (m_index[at] == none) {
    m_index[at] = m_kinds.size();
    m_kinds.push_back(kind);
  }
  return m_index[at];
}

}  // namespace alidade::ui
