#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade::console {

/// A session, with the SHA-256 of the bytes that it was read from.
struct SessionRead {
  Session session;
  std::string digest;
};

/// A session with its measurement.
struct SessionInput {
  std::string name;
  Session session;
  Measurement measurement;
  std::string digest = {};  ///< as in `SessionRead`
};

/// `file` is a path, or - for standard input.
Result<SessionRead> readSessionOf(const std::string& file);

/// Returns the session's title, or its file's name.
std::string nameOf(const Session& session, const std::string& file);

/// `prepare` changes the session before it is examined; `effects` are paths as in `addOwnEffects`. Fails with
/// the session's first problem.
Result<SessionInput> readSessionInput(const std::string& file, Session (*prepare)(Session) = nullptr,
                                      const std::vector<std::string>& effects = {});

/// Copies the instrument record at this path into the session; returns the reason of a failure.
std::optional<Problem> addRecord(Session& session, const std::string& record);

/// Reads a session and adds the instrument record at `record` (empty: none) without changing the file.
Result<SessionInput> readSessionInput(const std::string& file, const std::string& record,
                                      const std::vector<std::string>& effects = {});

}  // namespace alidade::console
