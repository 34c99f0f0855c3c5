#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <optional>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

// Sessions and their files. Long ones take a while; every function may run on any thread.

/// A session as read from a file.
struct FiledSession {
  Session session;
  QByteArray sha256;  ///< of the file's bytes
};

/// The contents of a file, whether a session or not.
struct FileContent {
  QByteArray sha256;
  Result<Session> session;
};

/// Reads a session, which may have invalid entries; the problem says why a file is not a session.
Result<FiledSession> readFiled(const QString& path);
/// Writes completely or not at all: the old file remains if writing fails, or if `path` is one of `inputs`,
/// files read for the session. Returns the SHA-256 of the written bytes.
Result<QByteArray> writeFiled(const Session& session, const QString& path, const QStringList& inputs);
/// Absent if the file is missing or unreadable, or its SHA-256 is the known one.
std::optional<FileContent> contentOtherThan(const QByteArray& knownSha256, const QString& path);
/// Empty if the file is missing or unreadable.
QByteArray sha256OfFile(const QString& path);

}  // namespace alidade::ui
