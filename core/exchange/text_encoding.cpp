#include "core/exchange/text_encoding.h"

#include <iconv.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "core/base/limits.h"
#include "core/base/phrase.h"
#include "core/base/utf8.h"

namespace alidade {

namespace {

/// A character of Windows-1252 that differs from Latin-1 and occurs in angles; � for other bytes.
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

bool isBeyondAscii(char c) {
  return static_cast<unsigned char>(c) >= 0x80;
}

bool isWithin(char c, unsigned char first, unsigned char last) {
  return static_cast<unsigned char>(c) >= first && static_cast<unsigned char>(c) <= last;
}

/// Is this a sign (A1-A9) or one of the 3755 common characters (B0-D7) of GB 2312?
bool isCommonChinese(char lead, char trail) {
  return (isWithin(lead, 0xA1, 0xA9) || isWithin(lead, 0xB0, 0xD7)) && isWithin(trail, 0xA1, 0xFE);
}

bool isChinese(char lead, char trail) {
  return isWithin(lead, 0x81, 0xFE) && isWithin(trail, 0x40, 0xFE) && trail != '\x7F';
}

/// Are all bytes beyond ASCII pairs of Chinese characters, most of them common?
bool looksChinese(std::string_view bytes) {
  std::size_t common = 0, rare = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    if (!isBeyondAscii(bytes[at])) continue;
    if (at + 1 == bytes.size() || !isChinese(bytes[at], bytes[at + 1])) return false;
    ++(isCommonChinese(bytes[at], bytes[at + 1]) ? common : rare);
    ++at;
  }
  return common > 2 * rare;
}

bool isCyrillicLetter(char c) {
  return isWithin(c, 0xC0, 0xFF) || isWithin(c, 0xA8, 0xA8) || isWithin(c, 0xB8, 0xB8);
}

/// Are most bytes beyond ASCII in words of three or more Cyrillic letters? Accented Latin letters are in
/// no such words. `only`: every byte beyond ASCII must also be a Cyrillic capital. Such text is tested first,
/// since pairs of capitals may look like common Chinese characters.
bool looksCyrillic(std::string_view bytes, bool only) {
  constexpr std::size_t shortestWord = 3;
  std::size_t inWords = 0, all = 0, run = 0;
  bool areCapitals = true;
  for (std::size_t at = 0; at <= bytes.size(); ++at) {
    const char c = at < bytes.size() ? bytes[at] : ' ';
    if (isBeyondAscii(c)) {
      ++all;
      areCapitals = areCapitals && isWithin(c, 0xC0, 0xDF);
    }
    if (isCyrillicLetter(c)) {
      ++run;
    } else {
      if (run >= shortestWord) inWords += run;
      run = 0;
    }
  }
  return 2 * inWords > all && (!only || areCapitals);
}

/// Detects UTF-16 without a byte order mark: every other byte of ASCII text is 0.
const char* unmarkedUtf16(std::string_view bytes) {
  constexpr std::size_t lookedAt = 4096, few = 20;
  const std::string_view start = bytes.substr(0, lookedAt);
  std::size_t even = 0, odd = 0;
  for (std::size_t at = 0; at < start.size(); ++at)
    if (start[at] == '\0') ++(at % 2 == 0 ? even : odd);
  const auto isHalf = [&start](std::size_t zeros, std::size_t others) {
    return others * few < zeros && zeros * 5 > start.size() * 2;
  };
  if (isHalf(odd, even)) return "UTF-16LE";
  return isHalf(even, odd) ? "UTF-16BE" : nullptr;
}

/// The encoding's name; null if the bytes are not UTF-16.
const char* encodingOfUtf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return "UTF-16LE";
  return bytes.starts_with("\xFE\xFF") ? "UTF-16BE" : unmarkedUtf16(bytes);
}

struct IconvCloser {
  void operator()(void* converter) const { iconv_close(converter); }
};
using Converter = std::unique_ptr<std::remove_pointer_t<iconv_t>, IconvCloser>;

Problem notIn(const char* encoding) {
  return Problem{Phrase::of("looks like text in %1, but is not: save it as UTF-8 text", encoding)};
}

Result<std::string> converted(std::string_view bytes, const char* encoding) {
  const iconv_t opened = iconv_open("UTF-8", encoding);
  if (reinterpret_cast<std::intptr_t>(opened) == -1)
    return Problem{
        Phrase::of("is text in %1, which cannot be read on this computer: save it as UTF-8 text", encoding)};
  const Converter converter(opened);
  std::string source(bytes), part(std::size_t{1} << 16, '\0'), text;
  char* in = source.data();
  std::size_t left = source.size();
  while (left > 0) {
    char* out = part.data();
    std::size_t room = part.size();
    const bool isDone = iconv(opened, &in, &left, &out, &room) != static_cast<std::size_t>(-1);
    if (!isDone && errno != E2BIG) return notIn(encoding);
    text.append(part, 0, part.size() - room);
    if (text.size() > limits::mostBytes) return limits::tooManyBytes();
  }
  return text;
}

}  // namespace

bool isUtf16(std::string_view bytes) {
  return encodingOfUtf16(bytes) != nullptr;
}

Result<std::string> decodedText(std::string_view bytes) {
  constexpr std::string_view markOfUtf8 = "\xEF\xBB\xBF";
  if (const char* const encoding = encodingOfUtf16(bytes)) {
    const Result<std::string> text = converted(bytes, encoding);
    return text && text->starts_with(markOfUtf8) ? text->substr(markOfUtf8.size()) : text;
  }
  if (bytes.starts_with(markOfUtf8)) bytes.remove_prefix(markOfUtf8.size());
  if (!firstIllFormedByte(bytes)) return std::string(bytes);
  if (looksCyrillic(bytes, true)) return converted(bytes, "CP1251");
  if (looksChinese(bytes)) return converted(bytes, "GB18030");
  if (looksCyrillic(bytes, false)) return converted(bytes, "CP1251");
  return fromWindows(bytes);
}

}  // namespace alidade
