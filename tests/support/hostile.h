#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace alidade::test {

/// Names that try to control a terminal, reverse or hide text, or act as markup.
struct HostileText {
  const char* what;
  std::string_view text;
};

/// All of them UTF-8, without path separators and NUL, so that they can also be file names.
inline constexpr std::array hostileTexts = {
    HostileText{"clear the screen", "a\x1b[2J\x1b[Hb"},
    HostileText{"set the terminal's title",
                "a\x1b]0;owned\x07"
                "b"},
    HostileText{"C1 controls", "a\u009b31mred\u0090q\u009c\u0085b"},
    HostileText{"bell, backspace, delete",
                "a\x07\x08\x08\x7f"
                "b"},
    HostileText{"overwrite the line", "Rejected\rAccepted"},
    HostileText{"a line of its own", "a\n\nVerdict: accept. Fine\v\f"},
    HostileText{"separators", "a\u2028b\u2029c"},
    HostileText{"overrides", "report\u202Efdp.exe\u202C\u202A\u202B\u202D"},
    HostileText{"isolates and marks", "a\u2066b\u2067c\u2068d\u2069\u200E\u200F\u061C"},
    HostileText{"not seen", "pay\u200Bpal\u2060\uFEFF\u00AD\u200D\u200C"},
    HostileText{"tags", "a\U000E0041\U000E0042\U000E007F"},
    HostileText{"markup", "<b>bold<i><img src=\"x.png\"><a href=\"x\">go<br>&amp;&File & co"},
    HostileText{"placeholders", "%1 %2 %n %s[*] {0}\\u202e\tCtrl+Q"},
};

/// The first place of a shown text with forbidden content: control characters other than those in `allowed`,
/// characters that reverse or hide text, or invalid UTF-8. A separate implementation of the Unicode rules,
/// independent of the program's.
inline std::optional<std::size_t> firstForbidden(std::string_view text, std::string_view allowed = "\n") {
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const std::size_t length = byte < 0x80       ? 1
                               : byte >> 5 == 6  ? 2
                               : byte >> 4 == 14 ? 3
                               : byte >> 3 == 30 ? 4
                                                 : 0;
    if (length == 0 || at + length > text.size()) return at;
    std::uint32_t code = length == 1 ? byte : byte & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
      const auto next = static_cast<unsigned char>(text[at + i]);
      if (next >> 6 != 2) return at;
      code = code << 6 | (next & 0x3Fu);
    }
    const bool kept = length == 1 && allowed.find(text[at]) != std::string_view::npos;
    const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    const bool turns = code == 0x61C || code == 0x200E || code == 0x200F ||
                       (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
    const bool undetectable = code == 0xAD || (code >= 0x200B && code <= 0x200D) ||
                              (code >= 0x2060 && code <= 0x2064) || code == 0xFEFF ||
                              (code >= 0xE0000 && code <= 0xE007F);
    if ((control && !kept) || turns || undetectable) return at;
    at += length;
  }
  return std::nullopt;
}

}  // namespace alidade::test
