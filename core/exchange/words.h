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

/// What people call a field of a row, an axis or a kind of vertical circle by its key in files; another word
/// as it is.
std::string spokenKey(std::string_view key);

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words);

}  // namespace alidade
