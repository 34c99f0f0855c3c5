#pragma once

#include <string>

#include "core/adjustment/arc/arc_fault.h"

namespace alidade {

/// The end of a sentence "The arc at 0° …", without a full stop: "has readings of 2 places; …".
std::string textOf(const ArcFault& fault);

}  // namespace alidade
