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

}  // namespace alidade::ui
