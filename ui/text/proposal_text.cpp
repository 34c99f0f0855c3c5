#include "ui/text/proposal_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/session/face.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

QString proposalText(const Proposal& proposal, CircleUnit unit) {
  QStringList texts;
  for (const CellChange& change : proposal.changes)
    texts.append(change.where.field == "face" ? qText(faceName(change.text == "2" ? 2 : 1))
                                              : shownAngle(change.text, unit));
  return texts.join(QCoreApplication::translate("Proposal", " and "));
}

}  // namespace alidade::ui
