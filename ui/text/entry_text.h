#pragma once

#include <QString>
#include <string>

namespace alidade::ui {

inline QString qText(const std::string& text) {
  return QString::fromStdString(text);
}

/// An angle as typed, shown for reading: `3415224` as 341°52′24″, with as many decimals of seconds (0…3) as
/// it needs. What is no angle is shown as typed.
QString shownAngle(const std::string& typed);

}  // namespace alidade::ui
