#include "ui/text/cause_text.h"

#include <QCoreApplication>

#include "core/effects/catalogue.h"
#include "core/wording/size_text.h"
#include "ui/text/effect_text.h"

namespace alidade::ui {

QString parameterText(const Cause& cause, const CauseParameter& parameter) {
  const QString figure = qText(sizeWithStandard(parameter.value, parameter.sigma, parameter.unit));
  if (isNamedBy(cause.effect, parameter.name)) return figure;
  //: a number of an effect and its size: sag −0.298 mm (u 0.009)
  return QCoreApplication::translate("GapText", "%1 %2").arg(qText(parameterName(parameter.name)), figure);
}

}  // namespace alidade::ui
