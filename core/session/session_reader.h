#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade {

/// A session from its JSON document; the part of `readSession` that knows the keys.
Result<Session> sessionFromJson(const nlohmann::ordered_json& document);

}  // namespace alidade
