#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade {

/// Reads the text of a `*.alidade` file (JSON, UTF-8, format version 1). Fails, with the place, on text that
/// is not JSON (line and column), another format, a newer version, a missing required key or a value of the
/// wrong JSON type. Texts that mean nothing as numbers or angles are not its business: they are kept and
/// reported by `examine`.
Result<Session> readSession(std::string_view text);

/// The session as the text of a file, ending in a newline: indented by two blanks, one line per reading.
/// Starts from the origins, so that a load and save loses nothing; a session that was read and not changed is
/// written with equal JSON.
std::string writeSession(const Session& session);

/// Reads a session from a file; the sentence names the file's trouble where it cannot be opened.
Result<Session> loadSession(const std::string& path);

}  // namespace alidade
