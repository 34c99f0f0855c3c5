#include "core/terms/carrier.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace alidade {

namespace {

constexpr std::string_view carrierNames[] = {"radial", "tangential", "across",   "x",           "y",
                                             "z",      "horizontal", "vertical", "orientation", "slider"};

}  // namespace

std::string_view nameOf(FormCarrier carrier) {
  return carrierNames[static_cast<std::size_t>(carrier)];
}

std::optional<FormCarrier> carrierNamed(std::string_view name) {
  const auto found = std::ranges::find(carrierNames, name);
  if (found == std::end(carrierNames)) return std::nullopt;
  return static_cast<FormCarrier>(found - std::begin(carrierNames));
}

bool isOfCircles(FormCarrier carrier) {
  return carrier == FormCarrier::Horizontal || carrier == FormCarrier::Vertical ||
         carrier == FormCarrier::Orientation;
}

}  // namespace alidade
