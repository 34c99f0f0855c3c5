#pragma once

#include <string>

#include "core/answers/guidance_json.h"
#include "core/base/circle_unit.h"

namespace alidade::console {

/// What is next, what is left, what to take again and when it is enough, for people.
std::string guidanceText(const std::string& session, const Guidance& guidance, CircleUnit unit);

}  // namespace alidade::console
