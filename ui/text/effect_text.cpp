#include "ui/text/effect_text.h"

#include "core/wording/effect_name.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

/// True for ″ or °.
bool isSign(const QString& unit) {
  return unit == QStringLiteral("″") || unit == QStringLiteral("°");
}

}  // namespace

QString effectName(const std::string& id) {
  return qText(alidade::effectName(id));
}

QString effectText(const EffectEstimate& estimate) {
  const QString effect = effectName(estimate.effect);
  if (isNamedBy(estimate.effect, estimate.name)) return effect;
  return listText({effect, qText(parameterName(estimate.name))});
}

QString capitalised(QString text) {
  if (!text.isEmpty() && text[0].script() == QChar::Script_Latin) text[0] = text[0].toUpper();
  return text;
}

QString unitText(const std::string& unit) {
  return qText(signOf(unit)).trimmed();
}

QString withUnit(const QString& figure, const QString& unit) {
  return figure + (isSign(unit) || unit.isEmpty() ? unit : u' ' + unit);
}

QString withStandardUncertainty(double value, double u, const QString& unit) {
  const int decimals = decimalsFor(u);
  return QStringLiteral("%1 (u %2)")
      .arg(withUnit(numberText(value, decimals), unit), numberText(u, decimals));
}

QString plausibleText(const EffectParameter& parameter) {
  return withUnit(plainNumberText(parameter.plausible), unitText(std::string(parameter.unit)));
}

QString effectUnitText(const EffectEstimate& estimate) {
  return unitText(estimate.unit);
}

}  // namespace alidade::ui
