#include "ui/text/closure_text.h"

#include <cmath>

#include "core/base/statistics.h"
#include "ui/text/effect_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

double expandedOf(const Closure& closure, double coverage) {
  return coverageFactor(coverage, DegreesOfFreedom::infinite()) * closure.sigma;
}

QString closureText(const Closure& closure, double coverage) {
  return valueWithUncertainty(closure.value, expandedOf(closure, coverage), QStringLiteral("mm"));
}

QString closureSigmasText(const Closure& closure) {
  return numberText(closure.sigmas(), 1) + QStringLiteral(" σ");
}

QString requiredSizeText(const Required& required) {
  return withUnit(numberText(required.size, decimalsFor(std::abs(required.size))), unitText(required.unit));
}

QString plausibleSizesText(const Required& required) {
  constexpr double least = 0.1;
  return required.plausibleSizes < least ? QStringLiteral("< ") + plainNumberText(least)
                                         : numberText(required.plausibleSizes, 1);
}

}  // namespace alidade::ui
