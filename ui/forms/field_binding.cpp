#include "ui/forms/field_binding.h"

#include <QWidget>
#include <utility>

#include "core/session/entry.h"
#include "core/session/measurement.h"
#include "ui/commands/change_session.h"
#include "ui/document/field.h"
#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

FieldBinding::FieldBinding(SessionDocument& document, Place place, QWidget* widget)
    : QObject(widget), m_document(document), m_place(std::move(place)) {
  connect(&document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    const bool mine = change.kind == SessionChange::Kind::Field &&
                      (change.place == m_place || change.place.field == "instrument.angle_unit");
    if (mine || change.kind == SessionChange::Kind::Everything) emit refreshed();
  });
}

QWidget* FieldBinding::widget() const {
  return qobject_cast<QWidget*>(parent());
}

QString FieldBinding::text() const {
  return qText(fieldText(m_document.session(), m_place));
}

QString FieldBinding::problem() const {
  const std::string typed = fieldText(m_document.session(), m_place);
  if (typed.empty()) return {};
  const auto sentence = entryProblem(m_document.session(), m_place.field, typed);
  return sentence ? qText(*sentence) : QString();
}

void FieldBinding::noteTyped(const QString& text) {
  const std::string typed = text.toStdString();
  m_document.halfTyped().set(this, {.place = m_place, .text = typed},
                             typed != fieldText(m_document.session(), m_place));
}

void FieldBinding::noteTypingEnded() {
  m_document.halfTyped().clear(this);
}

void FieldBinding::enter(const QString& text) {
  noteTypingEnded();
  changeField(m_document, m_place, text.toStdString());
}

CircleUnit FieldBinding::angleUnit() const {
  return circleUnitOf(m_document.session());
}

}  // namespace alidade::ui
