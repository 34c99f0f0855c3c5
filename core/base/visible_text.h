#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace alidade {

/// User text in a form that is safe to show. Characters that would control a terminal, reverse the order of
/// the line or be invisible appear as their JSON escape, \u001b or \u202e. These are the control characters
/// (C0, DEL, C1), the line and paragraph separators and all characters that Unicode defines as invisible. A
/// joiner or variation selector stays if it shapes the character before it. A byte that is not UTF-8 appears
/// as \xff. Everything else stays unchanged, including backslashes. The control characters in `kept` stay.
///
/// Within a JSON document, the escapes mean the same characters: the document's content does not change.
std::string visibleText(std::string_view text, std::string_view kept = {});

/// The visible text, cut to its first `most` characters and an ellipsis; an escape counts as one character.
std::string shortened(std::string_view text, std::size_t most);

/// User text for a sentence: shortened to 40 characters, in “ ”.
std::string quotation(std::string_view text);

/// Replaces every byte that is not UTF-8 by its value as an escape, such as \xff; everything else stays.
std::string wellFormed(std::string_view text);

}  // namespace alidade
