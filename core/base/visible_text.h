#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace alidade {

/// Somebody's text as it may be shown: what would act on a terminal, turn the order of the line or not be
/// seen at all stands there as the escape that JSON has for it, \u001b or \u202e. These are the control
/// characters (C0, DEL, C1), the line and paragraph separators and all that Unicode draws as nothing; the
/// joiners and variation selectors stay where they belong, behind a character of a script or a picture that
/// is shaped by them. A byte that is no UTF-8 stands as \xff. All else is as it was, a backslash too. The
/// control characters in `kept` stay.
///
/// Within a JSON document the escapes mean what they stand for, so that the document still says the same.
std::string visibleText(std::string_view text, std::string_view kept = {});

/// The same, cut to its first `most` characters and an ellipsis; an escape counts as the one it stands for.
std::string shortened(std::string_view text, std::size_t most);

/// What somebody typed, for a sentence: shortened to 40 characters, in “ ”.
std::string quotation(std::string_view text);

/// Every byte that is no UTF-8 as \xff; all else as it was.
std::string wellFormed(std::string_view text);

}  // namespace alidade
