#include "core/exchange/foreign_files.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "core/exchange/words.h"

namespace alidade {

namespace {

using namespace std::string_view_literals;

bool startsWithOneOf(std::string_view bytes, std::initializer_list<std::string_view> marks) {
  return std::ranges::any_of(marks, [bytes](std::string_view mark) { return bytes.starts_with(mark); });
}

bool holdsPart(std::string_view bytes, std::string_view part) {
  return bytes.find(part) != std::string_view::npos;
}

bool isZip(std::string_view bytes) {
  return startsWithOneOf(bytes, {"PK\x03\x04"sv, "PK\x05\x06"sv});
}

std::string_view withoutBlanksBefore(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

/// The text after the next `end`; empty if there is none.
std::string_view behind(std::string_view text, std::string_view end) {
  const std::size_t at = text.find(end);
  return at == std::string_view::npos ? std::string_view()
                                      : withoutBlanksBefore(text.substr(at + end.size()));
}

/// The text after a document type declaration. Its part in [ ] may contain >.
std::string_view behindDocumentType(std::string_view text) {
  const std::size_t inner = text.find_first_of("[>");
  const bool hasInner = inner != std::string_view::npos && text[inner] == '[';
  return hasInner ? behind(behind(text, "]"), ">") : behind(text, ">");
}

bool isXmlNameSign(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '.' || c == ':' || static_cast<unsigned char>(c) >= 0x80;
}

}  // namespace

bool looksLikePdf(std::string_view bytes) {
  return bytes.starts_with("%PDF-");
}

bool looksLikeExcel(std::string_view bytes) {
  return isZip(bytes) && (holdsPart(bytes, "xl/") || holdsPart(bytes, "[Content_Types].xml"));
}

bool looksLikeOpenDocument(std::string_view bytes) {
  return isZip(bytes) && holdsPart(bytes, "application/vnd.oasis.opendocument");
}

bool looksLikeArchive(std::string_view bytes) {
  return isZip(bytes) || startsWithOneOf(bytes, {"\x1F\x8B"sv, "7z\xBC\xAF"sv, "Rar!\x1A"sv});
}

bool looksLikeOldOffice(std::string_view bytes) {
  return bytes.starts_with("\xD0\xCF\x11\xE0"sv);
}

bool looksLikeDatabase(std::string_view bytes) {
  return startsWithOneOf(bytes, {"SQLite format 3\0"sv, "\0\1\0\0Standard "sv});
}

bool looksLikeImage(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, std::min<std::size_t>(bytes.size(), 16));
  return startsWithOneOf(bytes,
                         {"\x89PNG"sv, "\xFF\xD8\xFF"sv, "GIF87a"sv, "GIF89a"sv, "II*\0"sv, "MM\0*"sv}) ||
         (head.starts_with("RIFF") && holdsPart(head, "WEBP")) ||
         (head.starts_with("BM") && holdsPart(head, "\0\0"sv)) ||
         (head.size() > 8 && head.substr(4, 4) == "ftyp");
}

bool looksLikeDrawing(std::string_view bytes) {
  return bytes.starts_with("AC10") &&
         holdsPart(bytes.substr(0, std::min<std::size_t>(bytes.size(), 16)), "\0"sv);
}

bool looksLikeCarlsonCrd(std::string_view bytes) {
  return holdsPart(bytes.substr(0, std::min<std::size_t>(bytes.size(), 64)), "CRD Format");
}

bool looksLikeNothing(std::string_view) {
  return false;
}

bool looksLikeDxf(std::string_view text) {
  const auto lines = contentLines(text, 20);
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    const std::string code = trimmed(lines[i]);
    if (code == "0") return trimmed(lines[i + 1]) == "SECTION";
    if (code != "999") return false;  // 999 is a comment
  }
  return false;
}

bool looksLikeRtf(std::string_view text) {
  return withoutBlanksBefore(text).starts_with("{\\rtf");
}

bool looksLikeHtml(std::string_view text) {
  const std::string_view content = withoutBlanksBefore(text);
  constexpr std::size_t longestMark = 14;
  const std::string mark = lowerCase(std::string(content.substr(0, std::min(content.size(), longestMark))));
  return mark.starts_with("<!doctype html") || lowerCase(std::string(xmlRootName(text))) == "html" ||
         lowerCase(std::string(xmlRootName(text))) == "table";
}

bool looksLikeOtherXml(std::string_view text) {
  return !xmlRootName(text).empty() &&
         (withoutBlanksBefore(text).starts_with("<?xml") || holdsPart(text, "</") || holdsPart(text, "/>"));
}

bool looksLikeJson(std::string_view text) {
  const std::string_view content = withoutBlanksBefore(text);
  if (content.starts_with('{')) return true;
  return content.starts_with('[') && startsWithOneOf(withoutBlanksBefore(content.substr(1)), {"{", "["});
}

bool looksLikePostScript(std::string_view text) {
  return withoutBlanksBefore(text).starts_with("%!PS");
}

std::string_view xmlRootName(std::string_view text) {
  text = withoutBlanksBefore(text);
  while (text.starts_with("<?") || text.starts_with("<!"))
    text = text.starts_with("<?")     ? behind(text, "?>")
           : text.starts_with("<!--") ? behind(text, "-->")
                                      : behindDocumentType(text);
  if (!text.starts_with('<')) return {};
  text.remove_prefix(1);
  const auto end = std::ranges::find_if_not(text, isXmlNameSign);
  const std::string_view name = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  const bool isName =
      !name.empty() && !(name[0] >= '0' && name[0] <= '9') && name[0] != '-' && name[0] != '.';
  const bool ends = name.size() < text.size() &&
                    std::string_view(" \t\r\n/>").find(text[name.size()]) != std::string_view::npos;
  return isName && ends ? name.substr(name.find(':') + 1) : std::string_view();
}

}  // namespace alidade
