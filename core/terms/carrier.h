#pragma once

#include <optional>
#include <string_view>

namespace alidade {

/// The displaced quantity of a form or a formula. `Radial`, `Tangential`, `Across`: the target, mm, in
/// directions that turn with the guideway. `X`, `Y`, `Z`: the target, mm in o0. `Horizontal`, `Vertical`: the
/// reading of one circle in face 1, arcseconds; `Vertical` as an elevation, positive upwards. `Orientation`:
/// both circles. `Slider`: the slider reading, arcseconds.
enum class FormCarrier { Radial, Tangential, Across, X, Y, Z, Horizontal, Vertical, Orientation, Slider };

std::string_view nameOf(FormCarrier carrier);
std::optional<FormCarrier> carrierNamed(std::string_view name);
/// True for the readings of the circles; false for the target and the slider reading.
bool isOfCircles(FormCarrier carrier);

}  // namespace alidade
