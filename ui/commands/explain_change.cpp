#include "ui/commands/explain_change.h"

#include <QCoreApplication>

#include "ui/document/session_document.h"

namespace alidade::ui {

ExplainChange::ExplainChange(SessionDocument& document, std::size_t first, std::size_t count,
                             const std::string& reason)
    : JournalledCommand(document, QCoreApplication::translate("ExplainChange", "State the reason")) {
  setEntries({explainingEntry(document.session().journal, first, count, reason)});
}

void ExplainChange::apply() {
  edit({.kind = SessionChange::Kind::Field, .place = {.field = "journal"}}, [](Session&) {});
}

}  // namespace alidade::ui
