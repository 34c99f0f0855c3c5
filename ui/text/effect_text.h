#pragma once

#include <QString>

#include "core/adjustment/result/session_fit.h"
#include "core/effects/catalogue.h"

namespace alidade::ui {

/// The common name of a catalogued effect: "trunnion tilt".
QString effectName(const std::string& id);

/// The common name of an estimated number: "trunnion tilt", or "plane tilt, tilt about x" with the number's
/// own name if the effect has several numbers.
QString effectText(const EffectEstimate& estimate);

/// The text with a capital first letter.
QString capitalised(QString text);

/// The figure with its unit: "12″", "0.05 mm". ″ and ° follow without a blank; `unit` is from `unitText`.
QString withUnit(const QString& figure, const QString& unit);
/// The value with two digits of u: "−0.298 mm (u 0.012)". The sign ± is reserved for U.
QString withStandardUncertainty(double value, double u, const QString& unit);

/// The displayed unit: "″" for "arcsec", "°" for "deg", empty for a bare number.
QString unitText(const std::string& unit);
/// The plausible size (1σ) of a number: "30″", "0.05 mm".
QString plausibleText(const EffectParameter& parameter);
QString effectUnitText(const EffectEstimate& estimate);

}  // namespace alidade::ui
