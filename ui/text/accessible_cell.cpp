#include "ui/text/accessible_cell.h"

#include <QCoreApplication>

namespace alidade::ui {

namespace {

struct AccessibleCell {
  Q_DECLARE_TR_FUNCTIONS(AccessibleCell)
};

}  // namespace

QString accessibleCell(const QString& shown, const QString& title) {
  //: of a cell of a table: the name of its column
  return shown.isEmpty() ? AccessibleCell::tr("%1: empty").arg(title) : shown;
}

}  // namespace alidade::ui
