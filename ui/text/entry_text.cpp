#include "ui/text/entry_text.h"

#include <algorithm>

#include "core/base/angle_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

QString shownAngle(const std::string& typed, CircleUnit unit, int leastDecimals) {
  const Result<Angle> angle = parseAngle(typed);
  return angle ? angleText(*angle, unit, std::max(leastDecimals, decimalsOf(*angle, unit)))
               : visibleLine(typed);
}

}  // namespace alidade::ui
