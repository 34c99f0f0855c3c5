#include "ui/commands/change_field.h"

#include <QCoreApplication>
#include <utility>

#include "core/session/day_text.h"
#include "ui/document/field.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

QString undoText(const Place& place) {
  const QString noun = QCoreApplication::translate("Field", fieldNamed(place.field)->noun);
  return QCoreApplication::translate("ChangeField", "Change %1").arg(noun);
}

}  // namespace

ChangeField::ChangeField(SessionDocument& document, const Place& place, std::string text)
    : JournalledCommand(document, undoText(place)),
      m_place(place),
      m_before(fieldText(document.session(), place)),
      m_after(std::move(text)) {
  setEntries(journal().judge(m_place, m_before, m_after));
}

void ChangeField::apply() {
  document().putField(m_place, m_after);
}
void ChangeField::revert() {
  document().putField(m_place, m_before);
}

std::vector<JournalEntry> ChangeField::allEntries() const {
  return journal().asStanding(m_place, m_before, m_after);
}

void changeField(SessionDocument& document, const Place& place, const std::string& typed) {
  const bool isDay = place.field == "measured_on" || place.field.ends_with(".date");
  const std::string text = isDay ? completedDay(typed) : typed;
  if (fieldText(document.session(), place) == text) return;
  document.push(new ChangeField(document, place, text));
}

}  // namespace alidade::ui
