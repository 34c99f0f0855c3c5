#pragma once

#include <string>
#include <string_view>

namespace alidade {

/// Typed text in plain signs, for reading numbers and angles: the minus sign becomes '-', primes and
/// typographic quotation marks become ' and ", º and ˚ become °, tabs and all kinds of blanks become ' ';
/// none at either end.
std::string plainSigns(std::string_view typed);

bool isDigit(char c);

}  // namespace alidade
