#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <optional>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

// Sessions and their files. Long ones take a while, so all of this may be done on any thread.

/// A session as a file has it.
struct FiledSession {
  Session session;
  QByteArray sha256;  ///< of the file's bytes
};

/// What is in a file, be it a session or not.
struct FileContent {
  QByteArray sha256;
  Result<Session> session;
};

/// A session with entries that mean nothing is one; the problem says why a file is none.
Result<FiledSession> readFiled(const QString& path);
/// All of it or nothing: the old file stays where writing fails, or `path` is one of `inputs`, files that
/// were read for the session. The SHA-256 of what was written.
Result<QByteArray> writeFiled(const Session& session, const QString& path, const QStringList& inputs);
/// Absent where there is no such file, it cannot be read, or its SHA-256 is the known one.
std::optional<FileContent> contentOtherThan(const QByteArray& knownSha256, const QString& path);
/// Empty where there is no such file or it cannot be read.
QByteArray sha256OfFile(const QString& path);

}  // namespace alidade::ui
