#include "core/wording/across.h"

#include <cmath>

#include "core/base/phrase.h"
#include "core/base/quantity_text.h"

namespace alidade {

bool isAcrossSignificant(const MeasuredIntersection& measured) {
  return measured.across && std::abs(measured.across->value) > measured.across->expanded;
}

std::string acrossSentence(const MeasuredIntersection& measured) {
  if (!measured.across)
    return Phrase::of(
        "The offset Δz of the arc's centre from the axis, across the plane of the arc, was not measured.");
  const auto& [value, sigma, expanded] = *measured.across;
  return Phrase::of("The arc's centre is Δz = %1 off the axis, across the plane of the arc.",
                    lengthWithUncertainty(value, expanded, decimalsFor(expanded)));
}

}  // namespace alidade
