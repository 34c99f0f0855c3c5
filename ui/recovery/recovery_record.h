#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <string>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

/// A session with unsaved changes.
struct RecoveryRecord {
  QString path;       ///< path of the session's file; empty: unsaved
  QByteArray sha256;  ///< hash of the file when the session was last read or written
  QDateTime keptAt;
  Session session;
  QString id = {};  ///< unique id, to which `HalfTypedRecord` refers
};

/// The text of a record: a line of JSON about the file, then the session as in a session file. The text after
/// the first line can be opened as a session.
std::string recoveryText(const RecoveryRecord& record);

/// Returns a problem if the bytes are not a `recoveryText`.
Result<RecoveryRecord> readRecovery(const std::string& bytes);

}  // namespace alidade::ui
