#pragma once

#include <optional>

#include "core/certificate/element.h"

namespace alidade {

/// An uncertainty as in the digital SI.
struct StatedUncertainty {
  double sigma = 0, expanded = 0;  ///< in the unit of its value; expanded = k σ
  double coverage = 0;             ///< 0…1
  const char* distribution = "normal";
  bool isOfLength = false;  ///< the value cannot be negative
  bool isTyped = false;     ///< value and uncertainty are stated as they were entered
};

/// A standard uncertainty by itself: k = 1.
StatedUncertainty standardUncertainty(double sigma);
/// A standard uncertainty that is stated as it was entered: k = 1.
StatedUncertainty typedUncertainty(double sigma);

struct StatedQuantity {
  const char* id = nullptr;       ///< xs:ID; null: none
  const char* refType = nullptr;  ///< of PTB's good practice; null: none
  Say name;
  double value = 0;
  const char* unit = "\\one";  ///< in the notation of the digital SI
  std::optional<StatedUncertainty> uncertainty = {};
  Say description = nullptr;  ///< empty: none
};

/// Rounds a number that has no uncertainty to `decimals` decimals.
double roundedTo(double value, int decimals);

/// Adds a `quantity` to a `data` element, or to another parent as `element`. A value that is not finite is
/// stated as missing; an infinite or zero uncertainty is omitted. An uncertainty has two significant digits,
/// and its value as many decimals.
void addQuantity(const Element& to, const StatedQuantity& quantity, const char* element = "quantity");

}  // namespace alidade
