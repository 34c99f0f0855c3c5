#pragma once

#include <string>

#include "core/adjustment/result/intersection.h"

namespace alidade {

/// "readings", "model effects", "known radius", "pointing zeros", "distance".
std::string textOf(UncertaintySource source);

}  // namespace alidade
