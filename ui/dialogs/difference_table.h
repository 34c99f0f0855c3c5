#pragma once

#include <QString>

#include "ui/text/session_difference.h"

class QTreeWidget;

namespace alidade::ui {

/// A list of the differences: place, and both texts under the titles `mine` and `theirs`. A last line counts
/// the unlisted ones. The caller owns the widget.
QTreeWidget* createDifferenceTable(const SessionDifference& difference, const QString& mine,
                                   const QString& theirs);

}  // namespace alidade::ui
