#pragma once

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

/// `prepare` is done to the session before it is examined. Fails with the first thing that is wrong in it.
Result<SessionInput> readSessionInput(const std::string& file, Session (*prepare)(Session) = nullptr);

}  // namespace alidade::console
