#include "ui/text/entry_text.h"

#include <cmath>

#include "core/base/angle_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

/// Decimals of seconds that show `angle` to a thousandth of a second without trailing noughts.
int secondsDecimals(Angle angle) {
  const auto milliseconds = std::llround(std::abs(angle.arcseconds()) * 1000);
  if (milliseconds % 1000 == 0) return 0;
  if (milliseconds % 100 == 0) return 1;
  return milliseconds % 10 == 0 ? 2 : 3;
}

}  // namespace

QString shownAngle(const std::string& typed) {
  const Result<Angle> angle = parseAngle(typed);
  return angle ? dmsText(*angle, secondsDecimals(*angle)) : visibleLine(typed);
}

}  // namespace alidade::ui
