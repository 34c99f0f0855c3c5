#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace alidade {

/// ASCII letters only.
std::string lowerCase(std::string text);
std::string upperCase(std::string text);

/// Without blanks and tabs at either end.
std::string trimmed(std::string_view text);

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words);

}  // namespace alidade
