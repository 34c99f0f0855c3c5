#include "core/base/visible_text.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/utf8.h"

namespace alidade {

namespace {

constexpr std::size_t longestQuote = 40;

struct Range {
  char32_t first, last;
};

/// Unicode 15: general categories Cc, Zl and Zp, all Default_Ignorable_Code_Point, and the marks of an
/// interlinear annotation. In ascending order.
constexpr std::array<Range, 21> hidden = {{
    {0x0000, 0x001F},   {0x007F, 0x009F},   {0x00AD, 0x00AD},   {0x034F, 0x034F},   {0x061C, 0x061C},
    {0x115F, 0x1160},   {0x17B4, 0x17B5},   {0x180B, 0x180F},   {0x200B, 0x200F},   {0x2028, 0x202E},
    {0x2060, 0x206F},   {0x3164, 0x3164},   {0xFE00, 0xFE0F},   {0xFEFF, 0xFEFF},   {0xFFA0, 0xFFA0},
    {0xFFF0, 0xFFFB},   {0x1BCA0, 0x1BCA3}, {0x1D173, 0x1D17A}, {0xE0000, 0xE00FF}, {0xE0100, 0xE01EF},
    {0xE01F0, 0xE0FFF},
}};

bool isHidden(char32_t code) {
  const auto* const range = std::ranges::lower_bound(hidden, code, {}, &Range::last);
  return range != hidden.end() && code >= range->first;
}

bool isJoiner(char32_t code) {
  return code == 0x200C || code == 0x200D;
}

bool isSelector(char32_t code) {
  return (code >= 0x180B && code <= 0x180D) || code == 0x180F || (code >= 0xFE00 && code <= 0xFE0F) ||
         (code >= 0xE0100 && code <= 0xE01EF);
}

/// Does the joiner or selector `code` change the shape of `before`? Characters of Arabic, Indic and later
/// scripts and pictures may change; Latin, Greek, Cyrillic and Hebrew characters do not.
bool isShapedBy(char32_t before, char32_t code) {
  constexpr char32_t firstShaped = 0x0600;
  return before >= firstShaped &&
         (isJoiner(code) ? !isJoiner(before) : isSelector(code) && !isSelector(before));
}

void appendHex(std::string& text, const char* lead, unsigned value, int digits) {
  text += lead;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
    text += "0123456789abcdef"[(value >> shift) & 0xFu];
}

void appendEscape(std::string& text, char32_t code) {
  if (code < 0x10000) return appendHex(text, "\\u", code, 4);
  const auto rest = static_cast<unsigned>(code) - 0x10000u;
  appendHex(text, "\\u", 0xD800u + (rest >> 10), 4);
  appendHex(text, "\\u", 0xDC00u + (rest & 0x3FFu), 4);
}

/// Processes a text character by character; `m_before` is the last character shown, or 0 after an escape.
class Writer {
 public:
  explicit Writer(std::string_view kept) : m_kept(kept) {}

  void add(const Utf8Character& character, std::string_view bytes) {
    const char32_t code = character.code;
    const bool keeps = code < 0x80 && m_kept.find(static_cast<char>(code)) != std::string_view::npos;
    const bool shows = keeps || !isHidden(code) || isShapedBy(m_before, code);
    m_before = shows && character.wellFormed ? code : 0;
    if (!character.wellFormed)
      appendHex(m_text, "\\x", static_cast<unsigned char>(bytes.front()), 2);
    else if (shows)
      m_text += bytes;
    else
      appendEscape(m_text, code);
  }

  /// Appends printable ASCII.
  void addPlain(std::string_view text) {
    m_text += text;
    m_before = static_cast<char32_t>(text.back());
  }

  void append(std::string_view text) { m_text += text; }
  std::string take() { return std::move(m_text); }

 private:
  std::string_view m_kept;
  char32_t m_before = 0;
  std::string m_text;
};

/// The printable ASCII at the start of the text, usually most of the text. It is processed at once.
std::string_view plainBeginning(std::string_view text) {
  return {text.begin(), std::ranges::find_if(text, [](char c) { return c < ' ' || c > '~'; })};
}

std::string visible(std::string_view text, std::string_view kept, std::size_t most) {
  Writer writer(kept);
  for (std::size_t left = most; !text.empty();) {
    if (left == 0) {
      writer.append("…");
      break;
    }
    if (const std::string_view plain = plainBeginning(text.substr(0, left)); !plain.empty()) {
      writer.addPlain(plain);
      text.remove_prefix(plain.size());
      left -= plain.size();
      continue;
    }
    const Utf8Character character = firstCharacter(text);
    writer.add(character, text.substr(0, character.length));
    text.remove_prefix(character.length);
    --left;
  }
  return writer.take();
}

}  // namespace

std::string visibleText(std::string_view text, std::string_view kept) {
  return visible(text, kept, std::numeric_limits<std::size_t>::max());
}

std::string shortened(std::string_view text, std::size_t most) {
  return visible(text, {}, most);
}

std::string quotation(std::string_view text) {
  return "“" + shortened(text, longestQuote) + "”";
}

std::string wellFormed(std::string_view text) {
  std::string formed;
  while (!text.empty()) {
    const std::size_t good = std::min(firstIllFormedByte(text).value_or(text.size()), text.size());
    formed += text.substr(0, good);
    text.remove_prefix(good);
    if (text.empty()) break;
    appendHex(formed, "\\x", static_cast<unsigned char>(text.front()), 2);
    text.remove_prefix(1);
  }
  return formed;
}

}  // namespace alidade
