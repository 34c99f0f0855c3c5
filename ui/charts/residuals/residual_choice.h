#pragma once

#include "ui/charts/plotting/row_choice.h"

namespace alidade::ui {

enum class CircleRead { Horizontal, Vertical, Slider };

/// "horizontal": in the user's language, and as in tables.
QString circleName(CircleRead circle);
const char* nameOf(CircleRead circle);

/// The contents of the residual chart, and its abscissa.
struct ResidualChoice {
  enum class Over {
    Slider,     ///< the slider coordinate s
    Order,      ///< the order in which the rows were read
    Elevation,  ///< e, from the pointing zero
    Azimuth,    ///< a, from the pointing zero
    Normal,     ///< the normal quantile of their rank, standardised
  };

  Over over = Over::Slider;
  bool isStandardised = false;
  RowChoice rows = {};
  bool horizontal = true, vertical = true, slider = false;

  bool operator==(const ResidualChoice&) const = default;
  bool takes(CircleRead circle) const {
    return circle == CircleRead::Horizontal ? horizontal : circle == CircleRead::Vertical ? vertical : slider;
  }
  /// True if residuals in units of their own scatter, w, are drawn.
  bool showsStandardised() const { return isStandardised || over == Over::Normal; }
};

/// The choice kept in the user's settings; missing parts have their defaults.
ResidualChoice keptResidualChoice();
void keep(const ResidualChoice& choice);

}  // namespace alidade::ui
