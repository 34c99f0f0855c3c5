#pragma once

#include <QString>

#include "core/adjustment/result/session_fit.h"
#include "core/effects/catalogue.h"

namespace alidade::ui {

/// An effect of the catalogue as people call it: "trunnion tilt".
QString effectName(const std::string& id);

/// An estimated number of an effect as people call it: "trunnion tilt", "plane tilt, tilt about x".
/// `separator` stands before the number's own name where the effect has several.
QString effectText(const EffectEstimate& estimate, const QString& separator = QStringLiteral(", "));

/// Does the effect's name say already which number it is, as "slider scale" does of "scale"?
bool isNamedBy(const std::string& effect, const std::string& parameter);

/// The text with a capital first letter.
QString capitalised(QString text);

/// "12″", "0.05 mm", no blank before ″ and °; `unit` as `unitText` writes it.
QString withUnit(const QString& figure, const QString& unit);
/// "−0.298 mm (u 0.009)": ± stands for U alone. Two digits of u.
QString withStandardUncertainty(double value, double u, const QString& unit);

/// The unit of the catalogue as it is written: "″" for "arcsec", "°" for "deg", empty for a bare number.
QString unitText(const std::string& unit);
/// 1σ of what is plausible of a number: "30″", "0.05 mm".
QString plausibleText(const EffectParameter& parameter);
QString effectUnitText(const EffectEstimate& estimate);

}  // namespace alidade::ui
