#include "ui/commands/change_session.h"

#include <QCoreApplication>

#include "core/evaluation/remedies.h"
#include "core/session/session_fields.h"
#include "core/session/time_text.h"
#include "ui/commands/change_part.h"
#include "ui/document/field.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

QString undoText(const Place& place) {
  const QString noun = QCoreApplication::translate("Field", fieldNamed(place.field)->noun);
  return QCoreApplication::translate("ChangeField", "Change %1").arg(noun);
}

/// The text to store: a day in the session's form, a number without its unit.
std::string completed(std::string_view field, const std::string& typed) {
  if (isDay(field)) return completedDay(typed);
  const SessionField* own = sessionFieldNamed(field);
  return own ? withoutUnit(*own, typed) : typed;
}

}  // namespace

void changeField(SessionDocument& document, const Place& place, const std::string& typed) {
  const std::string text = completed(place.field, typed);
  const std::string before = fieldText(document.session(), place);
  if (before == text) return;
  const auto partOf = [field = fieldNamed(place.field), position = place.position.value_or(0)](
                          Session& session) -> std::string& { return field->at(session, position); };
  document.push(
      new ChangePart<std::string>(document, undoText(place), partOf, text, changeAt(place, before, text)));
}

void stateNoise(SessionDocument& document, const StatedNoise& noise) {
  document.beginTogether(QCoreApplication::translate("StateNoise", "State σ of the circles"));
  changeField(document, {.field = "instrument.sigma_horizontal_arcsec"}, noise.horizontal);
  changeField(document, {.field = "instrument.sigma_vertical_arcsec"}, noise.vertical);
  document.endTogether();
}

}  // namespace alidade::ui
