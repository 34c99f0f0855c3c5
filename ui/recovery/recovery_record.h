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

/// A line of JSON about the file, then the session as its file text: without the first line, the rest opens
/// as a session.
std::string recoveryText(const RecoveryRecord& record);

/// A sentence if the bytes are not such a record.
Result<RecoveryRecord> readRecovery(const std::string& bytes);

}  // namespace alidade::ui
