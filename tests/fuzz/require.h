#pragma once

#include <stdexcept>
#include <string>

namespace alidade::fuzz {

/// What must hold for every input. A test fails by it, a fuzz target ends by it.
inline void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace alidade::fuzz
