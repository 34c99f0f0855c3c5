#include "core/exchange/text_lines.h"

#include <algorithm>

#include "core/base/limits.h"
#include "core/base/phrase.h"
#include "core/base/utf8.h"

namespace alidade {

namespace {

/// The signs of Windows-1252 that occur in angles and are not those of Latin-1; others of that range are
/// shown as �.
const char* windowsSign(unsigned char byte) {
  switch (byte) {
    case 0x85:
      return "…";
    case 0x91:
      return "‘";
    case 0x92:
      return "’";
    case 0x93:
      return "“";
    case 0x94:
      return "”";
    case 0x96:
      return "–";
    case 0x97:
      return "—";
    default:
      return "\uFFFD";
  }
}

Result<std::string> fromWindows(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    if (text.size() > limits::mostBytes) return limits::tooManyBytes();
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else if (byte < 0xA0) {
      text += windowsSign(byte);
    } else {
      text += static_cast<char>(0xC0u | (byte >> 6u));
      text += static_cast<char>(0x80u | (byte & 0x3Fu));
    }
  }
  return text;
}

}  // namespace

std::optional<TextLine> TextLines::next() {
  if (m_rest.empty()) return std::nullopt;
  const std::size_t end = std::min(m_rest.find_first_of("\r\n"), m_rest.size());
  const TextLine line{++m_number, m_rest.substr(0, end)};
  const bool two = m_rest.substr(end, 2) == "\r\n";
  m_rest.remove_prefix(std::min(m_rest.size(), end + (two ? 2 : 1)));
  return line;
}

std::size_t characterCount(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(firstCharacter(text).length);
  return count;
}

Result<std::string> utf8Text(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    return Problem{Phrase::of("is UTF-16: save it as UTF-8 text")};
  if (bytes.find('\0') != std::string_view::npos)
    return Problem{Phrase::of("is no text: choose a GSI file, or a table saved as CSV")};
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  return firstIllFormedByte(bytes) ? fromWindows(bytes) : std::string(bytes);
}

}  // namespace alidade
