#include "ui/commands/state_noise.h"

#include <QCoreApplication>

#include "ui/commands/change_field.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

void stateNoise(SessionDocument& document, const StatedNoise& noise) {
  document.beginTogether(QCoreApplication::translate("StateNoise", "State σ of the circles"));
  changeField(document, {.field = "instrument.sigma_horizontal_arcsec"}, noise.horizontal);
  changeField(document, {.field = "instrument.sigma_vertical_arcsec"}, noise.vertical);
  document.endTogether();
}

}  // namespace alidade::ui
