#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <string>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

/// A session with changes that its file lacks.
struct RecoveryRecord {
  QString path;       ///< of the session's file; empty: in none yet
  QByteArray sha256;  ///< of the file as it was when the session was read from or written to it
  QDateTime keptAt;
  Session session;
  QString id = {};  ///< by which `HalfTypedRecord` knows it; of this record alone
};

/// A line of JSON that tells of the file, then the session as its file would be: who needs it may cut the
/// first line off and open the rest.
std::string recoveryText(const RecoveryRecord& record);

/// The sentence where the bytes are no such record.
Result<RecoveryRecord> readRecovery(const std::string& bytes);

}  // namespace alidade::ui
