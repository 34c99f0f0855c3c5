#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade {

/// Reads the text of a `*.alidade` file (JSON, UTF-8, format version 1). Fails, with the place, on text that
/// is not JSON (line and column), another format or a newer version. Also fails on a missing required key or
/// a value of the wrong JSON type. Invalid numbers and angles are kept as texts, for `examine` to report.
Result<Session> readSession(std::string_view text);

/// The session as the text of a file, ending in a newline: indented by two blanks, one line per reading.
/// Writing starts from the origins, so that load and save preserve everything; an unchanged session is
/// written with equal JSON.
std::string writeSession(const Session& session);

/// Reads a session from a file; the problem says why the file cannot be opened, or what is wrong in it.
Result<Session> loadSession(const std::string& path);

}  // namespace alidade
