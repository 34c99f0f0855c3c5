#pragma once

#include <stdexcept>
#include <string>

namespace alidade::fuzz {

/// A condition that must hold for every input. If it is violated, a test fails and a fuzz target ends.
inline void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace alidade::fuzz
