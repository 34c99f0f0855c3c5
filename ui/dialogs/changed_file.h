#pragma once

#include <QString>
#include <optional>

#include "ui/text/session_difference.h"

class QWidget;

namespace alidade::ui {

/// A file that another program wrote since it was opened or saved here.
struct ChangedFile {
  QString name;
  std::optional<SessionDifference> difference = {};  ///< absent: what stands there now is no session
  QString problem = {};                              ///< why it is none
};

enum class ChangedFileAnswer { Cancel, Reload, SaveAs, Overwrite };

/// Shows what differs and asks what to do. Reload is offered where there is a session to be read.
ChangedFileAnswer askChangedFile(QWidget* parent, const ChangedFile& file);

}  // namespace alidade::ui
