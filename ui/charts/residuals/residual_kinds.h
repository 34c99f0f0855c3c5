#pragma once

#include <QString>
#include <array>
#include <vector>

#include "ui/charts/plotting/plot_style.h"
#include "ui/charts/residuals/residual_picture.h"

namespace alidade::ui {

/// The residuals drawn with one marker.
struct ResidualKind {
  int axisDeg = 0;
  bool isAgain = false;  ///< a repeat at this axis angle
  CircleRead circle = CircleRead::Horizontal;
  bool isFaceTwo = false;

  /// Colour and fill show the axis, a ring shows a repeat, the shape shows the circle, a stroke shows face 2.
  /// The kinds stay distinguishable in grey.
  Marker marker(const PlotStyle& style) const;
  QString text() const;  ///< without the face
};

/// The kinds that occur, so that no others are drawn or computed.
class ResidualKinds {
 public:
  ResidualKinds() { m_index.fill(none); }

  /// The index of a residual's kind, added if new.
  std::size_t take(const DrawnResidual& residual);
  const std::vector<ResidualKind>& all() const { return m_kinds; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::array<std::size_t, 24> m_index;
  std::vector<ResidualKind> m_kinds;
};

}  // namespace alidade::ui
