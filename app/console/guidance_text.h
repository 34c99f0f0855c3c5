#pragma once

#include <string>

#include "core/answers/guidance_json.h"
#include "core/base/circle_unit.h"

namespace alidade::console {

/// The next and remaining sightings, the sightings to repeat, and when the readings are enough, as text.
std::string guidanceText(const std::string& session, const Guidance& guidance, CircleUnit unit);

}  // namespace alidade::console
