#pragma once

#include <string>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade::ui {

// What is exported of a session, fitted and diagnosed for it: the bytes of the file, or why there are none.
// `name` stands in the documents for the session. They need the whole session sound, as alidade-cli does.

Result<std::string> residualsAnswer(const Session& session, const std::string& name);
Result<std::string> resultAnswer(const Session& session, const std::string& name);
Result<std::string> gapAnswer(const Session& session, const std::string& name);
Result<std::string> budgetAnswer(const Session& session, const std::string& name);

}  // namespace alidade::ui
