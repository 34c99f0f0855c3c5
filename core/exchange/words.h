#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// Changes ASCII letters only.
std::string lowerCase(std::string text);
std::string upperCase(std::string text);

/// Removes blanks and tabs at both ends.
std::string trimmed(std::string_view text);

/// Compares exactly.
bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words);

/// Do these names mean one point? Case does not count, nor leading zeros of a number: 0007 is 7.
bool isSameName(std::string_view one, std::string_view other);

/// `text` in a form for comparing words: it has the signs of `plainSigns` (typed_text.h) and lower-case
/// letters, and its Latin and Cyrillic letters have no accents. `Höhe` and `HOHE` become `hohe`, `Приём`
/// becomes `прием`, `ß` becomes `ss`, `№` becomes `no`.
std::string foldedText(std::string_view text);

/// The first non-empty lines of a text, at most `most`, with their blanks. Blank lines and comments of
/// programs, which begin with # @ ? % or !, are skipped. The views live as long as `text`.
std::vector<std::string_view> contentLines(std::string_view text, std::size_t most = 20);

/// A line without leading blanks, tabs and start-of-transmission marks (STX).
std::string_view withoutIndent(std::string_view line);

/// The parts between the separators, unchanged; at least one.
std::vector<std::string_view> separatedParts(std::string_view line, char separator);

/// The name for people of a row's field, an axis or a kind of vertical circle, from its key in files; other
/// words are returned unchanged.
std::string plainKey(std::string_view key);

}  // namespace alidade
