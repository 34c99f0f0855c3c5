#pragma once

#include <QString>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

/// The name under which a report holds the session's file: as the file is called, so that it is known again.
QString attachedName(const QString& fileName);

/// Does the file begin as a PDF does? False also where it cannot be read.
bool isPdfFile(const QString& path);

/// The text of the session attached to a PDF: its first file with the suffix of a session. The problem says
/// why there is none.
Result<std::string> attachedSessionText(std::string_view pdf);

/// The session attached to the report in `path`. May be called on any thread.
Result<Session> readAttachedSession(const QString& path);

}  // namespace alidade::ui
