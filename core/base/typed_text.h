#pragma once

#include <string>
#include <string_view>

namespace alidade {

/// Typed text in plain signs, for reading numbers and angles. The minus sign and the en dash become '-';
/// primes, accents and typographic quotation marks that keyboards give for them become ' and "; º, ˚, ◦, ∘
/// and ⁰ become °; fullwidth digits, letters and punctuation become their ASCII forms; tabs and all kinds of
/// blanks become ' '. There are no blanks at either end.
std::string plainSigns(std::string_view typed);

bool isDigit(char c);

/// Is there a digit of another script, such as the Arabic ones? No number and no angle is read from these.
bool hasForeignDigits(std::string_view text);

}  // namespace alidade
