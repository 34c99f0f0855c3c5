#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "core/exchange/recording.h"

namespace alidade::console {

/// Checks the value of an option. Returns a sentence if the value is invalid, else an empty text.
using OptionCheck = std::function<std::string(const std::string&)>;

/// A finite number from `least` to `most`.
OptionCheck numberFrom(double least, double most);

/// A whole number from `least` to `most`: digits, with or without a plus sign.
OptionCheck wholeFrom(std::uint64_t least, std::uint64_t most);

/// Text valid in a session file: UTF-8.
OptionCheck textCheck();

/// The unit of an option: "dms", "deg" or "gon"; another name is `Unstated`.
AngleUnit angleUnitNamed(const std::string& name);

/// Accepts any whole number that is valid as a seed.
inline OptionCheck seedCheck() {
  return wholeFrom(0, std::numeric_limits<std::uint64_t>::max());
}

}  // namespace alidade::console
