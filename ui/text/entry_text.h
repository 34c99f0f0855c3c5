#pragma once

#include <QString>
#include <string>

#include "core/base/circle_unit.h"

namespace alidade::ui {

inline QString qText(const std::string& text) {
  return QString::fromStdString(text);
}

/// A typed angle shown in `unit`: `3415224` as 341°52′24″, with the decimals it needs (`decimalsOf`), at
/// least `leastDecimals` of seconds. An invalid angle is shown as typed.
QString shownAngle(const std::string& typed, CircleUnit unit, int leastDecimals = 0);

}  // namespace alidade::ui
