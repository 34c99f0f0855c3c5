#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade::console {

/// A session and what it means.
struct SessionInput {
  std::string name;
  Session session;
  Measurement measurement;
};

/// `file` is a path, or - for standard input.
Result<Session> readSessionOf(const std::string& file);

/// Its title, or its file's name.
std::string nameOf(const Session& session, const std::string& file);

/// What a session means; fails with the first thing that is wrong in it.
Result<Measurement> measurementOf(const Session& session);

/// `prepare` is done to the session before it is examined. Fails with the first thing that is wrong in it.
Result<SessionInput> readSessionInput(const std::string& file, Session (*prepare)(Session) = nullptr);

/// Copies what the instrument record at this path says into the session; where that fails, why.
std::optional<Problem> addRecord(Session& session, const std::string& record);

/// With what an instrument record says, for this run; `record` is its path, empty: none.
Result<SessionInput> readSessionInput(const std::string& file, const std::string& record);

}  // namespace alidade::console
