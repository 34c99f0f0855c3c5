#include "ui/panels/parts/protocol_menu.h"

#include <QMenu>

#include "core/simulation/protocol.h"
#include "core/wording/guidance.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

void addNamedProtocols(QMenu& menu, const std::function<void(const SightingProtocol&)>& follow) {
  for (const Protocol& named : namedProtocols()) {
    const SightingProtocol protocol = templateOf(named);
    QAction* action = menu.addAction(capitalised(qText(protocolInWords(protocol))));
    action->setObjectName(qText(named.name));
    QObject::connect(action, &QAction::triggered, &menu, [follow, protocol] { follow(protocol); });
  }
}

}  // namespace alidade::ui
