#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <optional>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

// Functions that read and write session files. Long files take a while; each function may run on any thread.

/// A session as read from a file.
struct FiledSession {
  Session session;
  QByteArray sha256;  ///< SHA-256 of the file's bytes
};

/// The hash of a file, and its session or the reason why the file is not a session.
struct FileContent {
  QByteArray sha256;
  Result<Session> session;
};

/// Reads a session, which may have invalid entries; the problem says why a file is not a session.
Result<FiledSession> readFiled(const QString& path);
/// Writes the file completely, or leaves the old file. Fails if `path` is one of `inputs`, the files read for
/// the session. Returns the SHA-256 of the written bytes.
Result<QByteArray> writeFiled(const Session& session, const QString& path, const QStringList& inputs);
/// The file's content; absent if the file is missing or unreadable, or if its SHA-256 is `knownSha256`.
std::optional<FileContent> contentOtherThan(const QByteArray& knownSha256, const QString& path);
/// Empty if the file is missing or unreadable.
QByteArray sha256OfFile(const QString& path);

}  // namespace alidade::ui
