#include "core/wording/across.h"

#include <cmath>

#include "core/base/quantity_text.h"

namespace alidade {

bool liesOff(const MeasuredIntersection& measured) {
  return measured.across && std::abs(measured.across->value) > measured.across->expanded;
}

std::string acrossSentence(const MeasuredIntersection& measured) {
  if (!measured.across)
    return "How far the arc's centre lies off the axis across the plane of the arc was not measured.";
  const int decimals = decimalsFor(measured.across->expanded);
  return "Across the plane of the arc its centre lies Δz = " + displayText(measured.across->value, decimals) +
         " mm ± " + displayText(measured.across->expanded, decimals) + " mm off the axis.";
}

}  // namespace alidade
