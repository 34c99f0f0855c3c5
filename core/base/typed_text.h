#pragma once

#include <string>
#include <string_view>

namespace alidade {

/// Typed text in plain signs, for reading numbers and angles. The minus sign and the en dash become '-';
/// primes, and the accents and typographic quotation marks that keyboards give for them, become ' and "; º,
/// ˚, ◦, ∘ and ⁰ become °; fullwidth digits, letters and punctuation become their ASCII forms; tabs and all
/// kinds of blanks become ' '. Blanks at both ends are removed.
std::string plainSigns(std::string_view typed);

bool isDigit(char c);

/// Does the text contain a digit of another script, such as Arabic? Numbers and angles with such digits are
/// refused.
bool hasForeignDigits(std::string_view text);

}  // namespace alidade
