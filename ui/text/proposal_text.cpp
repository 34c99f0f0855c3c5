#include "ui/text/proposal_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

QString proposalText(const Proposal& proposal, CircleUnit unit) {
  QStringList texts;
  for (const CellChange& change : proposal.changes)
    texts.append(change.where.field == "face"
                     ? QCoreApplication::translate("Proposal", "face %1").arg(visibleLine(change.text))
                     : shownAngle(change.text, unit));
  return texts.join(QCoreApplication::translate("Proposal", " and "));
}

}  // namespace alidade::ui
