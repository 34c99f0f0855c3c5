#pragma once

#include <QString>
#include <array>
#include <vector>

#include "ui/charts/plotting/plot_style.h"
#include "ui/charts/residuals/residual_picture.h"

namespace alidade::ui {

/// What is drawn with one marker.
struct ResidualKind {
  int axisDeg = 0;
  bool isAgain = false;  ///< at this axis for a second time or more
  CircleRead circle = CircleRead::Horizontal;
  bool isFaceTwo = false;

  /// Colour and filling tell the axis, a ring that it was measured again, the shape tells the circle, a
  /// stroke face 2: they stay apart in grey.
  Marker marker(const PlotStyle& style) const;
  QString text() const;  ///< without the face
};

/// The kinds that are there, so that no others are drawn or reckoned with.
class ResidualKinds {
 public:
  ResidualKinds() { m_index.fill(none); }

  /// Index of the kind of a residual among those that are there; it is from now on.
  std::size_t take(const DrawnResidual& residual);
  const std::vector<ResidualKind>& all() const { return m_kinds; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::array<std::size_t, 24> m_index;
  std::vector<ResidualKind> m_kinds;
};

}  // namespace alidade::ui
