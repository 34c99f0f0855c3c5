#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace alidade {

/// Changes ASCII letters only.
std::string lowerCase(std::string text);
std::string upperCase(std::string text);

/// Removes blanks and tabs at both ends.
std::string trimmed(std::string_view text);

/// The name for people of a row's field, an axis or a kind of vertical circle, from its key in files; other
/// words are returned unchanged.
std::string plainKey(std::string_view key);

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words);

}  // namespace alidade
