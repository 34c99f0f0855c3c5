#include "ui/commands/change_session.h"

#include <QCoreApplication>

#include "core/session/protocol_progress.h"
#include "ui/commands/change_part.h"
#include "ui/commands/change_positions.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

/// The text for the journal, such as `full, 138 sightings`.
std::string saidOf(const std::string& text) {
  Session alone;
  alone.protocol = text;
  const auto protocol = statedProtocol(alone);
  if (!protocol || !*protocol) return text.empty() ? "" : "unreadable";
  const std::string count = std::to_string(sightingCount(**protocol)) + " sightings" +
                            ((*protocol)->isByWorth ? ", by what each tells" : "");
  return (*protocol)->name.empty() ? count : (*protocol)->name + ", " + count;
}

}  // namespace

void followProtocol(SessionDocument& document, std::optional<SightingProtocol> protocol) {
  if (protocol) protocol->isYielding = false;
  const std::string text = protocol ? protocolText(*protocol) : std::string();
  if (text == document.session().protocol) return;
  const QString undoText = protocol ? QCoreApplication::translate("ChangeProtocol", "Follow a protocol")
                                    : QCoreApplication::translate("ChangeProtocol", "Follow no protocol");
  const std::vector<int> lacking =
      protocol ? positionsLacking(document.session(), *protocol) : std::vector<int>();
  document.beginTogether(undoText);
  for (const int axisDeg : lacking) addPosition(document, axisDeg);
  document.push(new ChangePart<std::string>(
      document, undoText, [](Session& session) -> std::string& { return session.protocol; }, text,
      changeAt({.field = "protocol"}, saidOf(document.session().protocol), saidOf(text))));
  document.endTogether();
}

}  // namespace alidade::ui
