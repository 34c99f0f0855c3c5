#include "ui/text/effect_text.h"

#include "ui/text/entry_text.h"

namespace alidade::ui {

QString effectText(const EffectEstimate& estimate, const QString& separator) {
  const QString effect = qText(estimate.effect).replace(QLatin1Char('_'), QLatin1Char(' '));
  const QString name = qText(estimate.name);
  return effect.endsWith(name) ? effect : effect + separator + name;
}

QString effectUnitText(const EffectEstimate& estimate) {
  if (estimate.unit == "arcsec") return QStringLiteral("″");
  if (estimate.unit == "deg") return QStringLiteral("°");
  return estimate.unit == "mm" ? QStringLiteral("mm") : QString();
}

}  // namespace alidade::ui
