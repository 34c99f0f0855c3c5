#pragma once

#include <string>

#include "core/adjustment/arc/arc_fault.h"

namespace alidade {

/// The predicate of a sentence about an arc, "has readings of 2 places; a circle …", without a full stop.
std::string textOf(const ArcFault& fault);

}  // namespace alidade
