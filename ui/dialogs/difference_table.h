#pragma once

#include <QString>

#include "ui/text/session_difference.h"

class QTreeWidget;

namespace alidade::ui {

/// What differs as a list: where, and both texts under the titles `mine` and `theirs`. A last line says how
/// many more there are. The caller owns the widget.
QTreeWidget* createDifferenceTable(const SessionDifference& difference, const QString& mine,
                                   const QString& theirs);

}  // namespace alidade::ui
