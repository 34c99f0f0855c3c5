#include "ui/commands/change_protocol.h"

#include <QCoreApplication>
#include <utility>

#include "core/session/protocol_progress.h"
#include "ui/commands/add_position.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

Place protocolPlace() {
  return {.field = "protocol"};
}

/// `full, 138 sightings`.
std::string saidOf(const std::string& text) {
  Session alone;
  alone.protocol = text;
  const auto protocol = protocolOf(alone);
  if (!protocol || !*protocol) return text.empty() ? "" : "unreadable";
  const std::string count = std::to_string(sightingCount(**protocol)) + " sightings";
  return (*protocol)->name.empty() ? count : (*protocol)->name + ", " + count;
}

}  // namespace

ChangeProtocol::ChangeProtocol(SessionDocument& document, std::string protocol, const QString& text)
    : JournalledCommand(document, text), m_before(document.session().protocol), m_after(std::move(protocol)) {
  setEntries(journal().judge(protocolPlace(), saidOf(m_before), saidOf(m_after)));
}

void ChangeProtocol::apply() {
  document().putField(protocolPlace(), m_after);
}
void ChangeProtocol::revert() {
  document().putField(protocolPlace(), m_before);
}

std::vector<JournalEntry> ChangeProtocol::allEntries() const {
  return journal().asStanding(protocolPlace(), saidOf(m_before), saidOf(m_after));
}

void followProtocol(SessionDocument& document, const std::optional<SightingProtocol>& protocol) {
  const std::string text = protocol ? protocolText(*protocol) : std::string();
  if (text == document.session().protocol) return;
  const QString undoText = protocol ? QCoreApplication::translate("ChangeProtocol", "Follow a protocol")
                                    : QCoreApplication::translate("ChangeProtocol", "Follow no protocol");
  const std::vector<int> lacking =
      protocol ? positionsLacking(document.session(), *protocol) : std::vector<int>();
  document.beginTogether(undoText);
  for (const int axisDeg : lacking) addPosition(document, axisDeg);
  document.push(new ChangeProtocol(document, text, undoText));
  document.endTogether();
}

}  // namespace alidade::ui
