#include "ui/text/spoken_cell.h"

#include <QCoreApplication>

namespace alidade::ui {

namespace {

struct SpokenCell {
  Q_DECLARE_TR_FUNCTIONS(SpokenCell)
};

}  // namespace

QString spokenCell(const QString& shown, const QString& title) {
  //: of a cell of a table: the name of its column
  return shown.isEmpty() ? SpokenCell::tr("%1: empty").arg(title) : shown;
}

}  // namespace alidade::ui
