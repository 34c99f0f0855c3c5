#pragma once

#include <QString>
#include <optional>

#include "ui/text/session_difference.h"

class QTreeWidget;
class QWidget;

namespace alidade::ui {

/// A file that another program changed after it was opened or saved here.
struct ChangedFile {
  QString name;
  std::optional<SessionDifference> difference = {};  ///< absent if the file is not a session now
  QString problem = {};                              ///< why the file is not a session
};

enum class ChangedFileAnswer { Cancel, Reload, SaveAs, Overwrite };

/// Shows the differences and asks what to do. Reload is offered if the file holds a readable session.
ChangedFileAnswer askChangedFile(QWidget* parent, const ChangedFile& file);

/// A list of the differences: place, and both texts under the titles `mine` and `theirs`. A last line counts
/// the unlisted differences. The caller owns the widget.
QTreeWidget* createDifferenceTable(const SessionDifference& difference, const QString& mine,
                                   const QString& theirs);

}  // namespace alidade::ui
