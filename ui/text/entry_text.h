#pragma once

#include <QString>
#include <string>

#include "core/base/circle_unit.h"

namespace alidade::ui {

inline QString qText(const std::string& text) {
  return QString::fromStdString(text);
}

/// An angle as typed, shown for reading in `unit`: `3415224` as 341°52′24″, as finely (`decimalsOf`) as it
/// needs, at least to `leastDecimals` of seconds. What is no angle is shown as typed.
QString shownAngle(const std::string& typed, CircleUnit unit, int leastDecimals = 0);

}  // namespace alidade::ui
