#include "core/exchange/text_lines.h"

#include <algorithm>

#include "core/base/phrase.h"
#include "core/base/utf8.h"
#include "core/exchange/text_encoding.h"

namespace alidade {

namespace {

constexpr char endOfFile = '\x1A';

/// Is this a control character that instruments send around their lines? ESC is not one of them.
bool isControl(char c) {
  constexpr unsigned char firstPrinting = 0x20, deletion = 0x7F, escape = 0x1B;
  const auto byte = static_cast<unsigned char>(c);
  return (byte < firstPrinting && byte != escape && c != '\t' && c != '\r' && c != '\n') || byte == deletion;
}

bool isOutsideText(char c) {
  return isControl(c) || c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// Is NUL used only as padding at the end of a line or text? NUL within a word means the file is not text.
bool isFilling(std::string_view text) {
  for (std::size_t at = text.find('\0'); at != std::string_view::npos; at = text.find('\0', at)) {
    const std::size_t end = std::min(text.find_first_not_of('\0', at), text.size());
    const bool isInside =
        at > 0 && end < text.size() && !isOutsideText(text[at - 1]) && !isOutsideText(text[end]);
    if (isInside) return false;
    at = end;
  }
  return true;
}

/// Removes control characters at the beginning of a line; replaces others by blanks.
std::string withoutControls(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (const char c : text) {
    const bool isBeginning = plain.empty() || plain.back() == '\n' || plain.back() == '\r';
    if (!isControl(c))
      plain += c;
    else if (!isBeginning)
      plain += ' ';
  }
  return plain;
}

bool hasControls(std::string_view text) {
  return std::any_of(text.begin(), text.end(), isControl);
}

}  // namespace

std::optional<TextLine> TextLines::next() {
  if (m_rest.empty()) return std::nullopt;
  static constexpr std::string_view ends = "\r\n\x1A";
  const std::size_t end = std::min(m_rest.find_first_of(ends), m_rest.size());
  const TextLine line{++m_number, m_rest.substr(0, end)};
  if (end < m_rest.size() && m_rest[end] == endOfFile) {
    m_rest = {};
    m_tailLine = m_number;
    return line.text.empty() ? std::nullopt : std::optional(line);
  }
  const bool two = m_rest.substr(end, 2) == "\r\n";
  m_rest.remove_prefix(std::min(m_rest.size(), end + (two ? 2 : 1)));
  return line;
}

std::string_view untilEndOfFile(std::string_view text) {
  return text.substr(0, text.find(endOfFile));
}

std::size_t characterCount(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(firstCharacter(text).length);
  return count;
}

Result<std::string> utf8Text(std::string_view bytes) {
  // The bytes after ^Z are leftovers of memory and do not show the encoding.
  const std::size_t end = isUtf16(bytes) ? bytes.size() : std::min(bytes.find(endOfFile), bytes.size());
  Result<std::string> decoded = decodedText(bytes.substr(0, end));
  if (!decoded) return decoded;
  std::string text = *std::move(decoded);
  const std::size_t endOfText = std::min(text.find(endOfFile), text.size());
  const auto hasText = [](std::string_view tail) {
    return !std::all_of(tail.begin(), tail.end(), isOutsideText);
  };
  const bool hasTail = hasText(bytes.substr(end)) || hasText(std::string_view(text).substr(endOfText));
  text.resize(endOfText);
  if (!isFilling(text))
    return Problem{Phrase::of("is not a text file: choose a GSI file, or a table saved as CSV")};
  if (hasControls(text)) text = withoutControls(text);
  if (hasTail) text += endOfFile;
  return text;
}

}  // namespace alidade
