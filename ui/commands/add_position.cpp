#include "ui/commands/add_position.h"

#include <QCoreApplication>
#include <algorithm>
#include <string>

#include "core/session/entry.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

AddPosition::AddPosition(SessionDocument& document, int axisDeg)
    : JournalledCommand(document, addPositionText(document.session(), axisDeg)),
      m_index(axisDeg == 0 && !hasPosition(document.session(), 0) ? 0 : document.session().positions.size()) {
  m_position.axisDeg = std::to_string(axisDeg);
  setEntries(journal().judge(place(), {}, m_position.axisDeg));
}

void AddPosition::apply() {
  insertPosition(m_index, m_position);
}
void AddPosition::revert() {
  erasePosition(m_index);
}

Place AddPosition::place() const {
  return {.position = m_index};
}

std::vector<JournalEntry> AddPosition::allEntries() const {
  return journal().asStanding(place(), {}, m_position.axisDeg);
}

bool hasPosition(const Session& session, int axisDeg) {
  return std::any_of(session.positions.begin(), session.positions.end(), [axisDeg](const Position& position) {
    const Result<int> axis = axisEntry(position.axisDeg);
    return axis && *axis == axisDeg;
  });
}

bool mayAddPosition(const Session& session, int axisDeg) {
  return !hasPosition(session, axisDeg) || hasPosition(session, axisDeg == 0 ? 180 : 0);
}

QString addPositionText(const Session& session, int axisDeg) {
  const QString text = hasPosition(session, axisDeg)
                           ? QCoreApplication::translate("AddPosition", "Measure %1° again")
                           : QCoreApplication::translate("AddPosition", "Add position at %1°");
  return text.arg(axisDeg);
}

void addPosition(SessionDocument& document, int axisDeg) {
  if (!mayAddPosition(document.session(), axisDeg)) return;
  document.push(new AddPosition(document, axisDeg));
}

}  // namespace alidade::ui
