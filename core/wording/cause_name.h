#pragma once

#include <string>

namespace alidade {

/// The name of anything a diagnosis may name, within a sentence: "trunnion tilt", "a jump of the
/// orientation", "misread values", "noise larger than stated". `id` is a cause's identifier.
std::string causeName(const std::string& id);

}  // namespace alidade
