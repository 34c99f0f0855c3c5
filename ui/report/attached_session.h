#pragma once

#include <QString>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

/// The name of the session attached to a report: the name of its file, with the suffix `.alidade`.
QString attachedName(const QString& fileName);

/// True if the file begins like a PDF; false also if it cannot be read.
bool isPdfFile(const QString& path);

/// The text of the session attached to a PDF, which is the first attached file with the suffix of a session;
/// a problem if no such file can be read.
Result<std::string> attachedSessionText(std::string_view pdf);

/// The session attached to the report in `path`. May be called on any thread.
Result<Session> readAttachedSession(const QString& path);

}  // namespace alidade::ui
