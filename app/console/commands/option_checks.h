#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace alidade::console {

/// What a value of an option may be: a sentence where it may not, else empty.
using OptionCheck = std::function<std::string(const std::string&)>;

/// A number, finite and from `least` to `most`.
OptionCheck numberFrom(double least, double most);

/// A whole number in digits alone, from `least` to `most`.
OptionCheck wholeFrom(std::uint64_t least, std::uint64_t most);

/// Text that a session file can hold: UTF-8.
OptionCheck textCheck();

/// Any whole number that a seed can be.
inline OptionCheck seedCheck() {
  return wholeFrom(0, std::numeric_limits<std::uint64_t>::max());
}

}  // namespace alidade::console
