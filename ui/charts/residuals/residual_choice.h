#pragma once

#include <array>

#include "ui/charts/plotting/row_choice.h"

namespace alidade::ui {

enum class CircleRead { Horizontal, Vertical, Slider };

/// The name of a circle, as "horizontal": `circleName` in the user's language, `nameOf` as in tables.
QString circleName(CircleRead circle);
const char* nameOf(CircleRead circle);

/// The contents of the residual chart, and its abscissa.
struct ResidualChoice {
  enum class Over {
    Slider,     ///< the slider coordinate s
    Order,      ///< the order in which the rows were read
    Elevation,  ///< e, from the pointing zero
    Azimuth,    ///< a, from the pointing zero
    Normal,     ///< standardised, over the normal quantile of their rank
    Count,      ///< a histogram: the number of residuals in each class
  };
  /// The axes of residuals; the range of each is set by hand separately.
  enum class Axis { Arcsec, Standardised, Normal, Classes, StandardisedClasses };

  Over over = Over::Slider;
  bool isStandardised = false;
  RowChoice rows = {};
  bool horizontal = true, vertical = true, slider = false;
  /// By `Axis`: half the range set by hand, in arcseconds or standardised; 0: as large as the contents need.
  std::array<double, 5> reaches = {};

  bool operator==(const ResidualChoice&) const = default;
  bool takes(CircleRead circle) const {
    return circle == CircleRead::Horizontal ? horizontal : circle == CircleRead::Vertical ? vertical : slider;
  }
  /// True if standardised residuals w are drawn.
  bool showsStandardised() const { return isStandardised || over == Over::Normal; }
  Axis axis() const;
  double reach() const { return reaches[static_cast<std::size_t>(axis())]; }
  void setReach(double reach) { reaches[static_cast<std::size_t>(axis())] = reach; }
};

/// The choice kept in the user's settings; missing parts have their defaults.
ResidualChoice keptResidualChoice();
void keep(const ResidualChoice& choice);

}  // namespace alidade::ui
