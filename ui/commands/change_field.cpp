#include "ui/commands/change_field.h"

#include <QCoreApplication>
#include <utility>

#include "ui/document/field.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

ChangeField::ChangeField(SessionDocument& document, const Place& place, std::string text)
    : m_document(document),
      m_place(place),
      m_before(fieldText(document.session(), place)),
      m_after(std::move(text)) {
  const QString noun = QCoreApplication::translate("Field", fieldNamed(place.field)->noun);
  setText(QCoreApplication::translate("ChangeField", "Change %1").arg(noun));
}

void ChangeField::undo() {
  m_document.putField(m_place, m_before);
}
void ChangeField::redo() {
  m_document.putField(m_place, m_after);
}

void changeField(SessionDocument& document, const Place& place, const std::string& text) {
  if (fieldText(document.session(), place) == text) return;
  document.push(new ChangeField(document, place, text));
}

}  // namespace alidade::ui
