#pragma once

#include <string>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

// Each function computes an export of a session and returns the bytes of the file, or the problem.
// `name` is the session's name in JSON documents. Like alidade-cli, the functions require every entry of the
// session to be valid.

Result<std::string> residualsAnswer(const Session& session, const std::string& name);
Result<std::string> resultAnswer(const Session& session, const std::string& name);
Result<std::string> gapAnswer(const Session& session, const std::string& name);
Result<std::string> budgetAnswer(const Session& session, const std::string& name);

}  // namespace alidade::ui
