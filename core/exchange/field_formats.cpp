#include "core/exchange/field_formats.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "core/base/typed_text.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

using FieldLines = std::vector<std::string_view>;

bool isLatinLetter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool hasSeparator(std::string_view line) {
  return line.find_first_of(",;\t") != std::string_view::npos;
}

bool beginsWithMark(std::string_view line, std::initializer_list<std::string_view> beginnings) {
  return std::ranges::any_of(beginnings, [line](std::string_view begin) { return line.starts_with(begin); });
}

/// Is the text a time such as 9:30:11 or 09:30:11?
bool isClockTime(std::string_view text) {
  const auto parts = separatedParts(text, ':');
  return parts.size() == 3 && std::ranges::all_of(parts, [](std::string_view part) {
           return !part.empty() && part.size() <= 2 && std::ranges::all_of(part, isDigit);
         });
}

bool isNikonSighting(std::string_view line) {
  const auto fields = separatedParts(line, ',');
  return isOneOf(fields[0], {"SS", "F1", "F2", "CP", "SO"}) && fields.size() >= 7 &&
         std::ranges::any_of(fields, isClockTime);
}

/// The known word at the start of a GTS-7 line, with a blank after it; empty for other lines.
std::string_view gts7Word(std::string_view line) {
  static constexpr std::array<std::string_view, 29> words{
      "JOB", "DATE", "NAME", "INST", "UNITS",  "SCALE", "ATMOS", "STN", "STA",  "XYZ",
      "NEZ", "ENZ",  "BKB",  "BS",   "FS",     "SS",    "SC",    "SD",  "SA",   "CTL",
      "HV",  "HVD",  "HD",   "RD",   "OFFSET", "NOTE",  "MLM",   "PTL", "PRISM"};
  const std::string_view word = line.substr(0, line.find(' '));
  const bool isKnown = word.size() < line.size() && std::ranges::find(words, word) != words.end();
  return isKnown ? word : std::string_view();
}

/// The number of values such as 7=107.1225 in a line; 0 if it contains anything else.
std::size_t labelledValues(std::string_view line) {
  std::size_t count = 0;
  for (const std::string_view part : separatedParts(line, ',')) {
    const std::string item = trimmed(part);
    const std::size_t sign = item.find('=');
    const std::string label = sign == std::string::npos ? std::string() : trimmed(item.substr(0, sign));
    constexpr std::size_t longestLabel = 3;
    if (label.empty() || label.size() > longestLabel || !std::ranges::all_of(label, isDigit)) return 0;
    ++count;
  }
  return count;
}

constexpr std::size_t rec500Type = 36;  // column of the first value's type, from 0

/// Does the line begin with three blanks, a four-digit address and a blank?
bool hasRec500Address(std::string_view line) {
  constexpr std::size_t address = 8;
  return line.size() > address && line.starts_with("   ") && line[7] == ' ' &&
         std::all_of(line.begin() + 3, line.begin() + 7, isDigit);
}

bool hasRec500Value(std::string_view line) {
  return line.size() > rec500Type + 4 && line[rec500Type - 1] == ' ' &&
         isOneOf(trimmed(line.substr(rec500Type, 2)), {"Hz", "V", "V1", "V2", "V3", "X", "Y", "Z", "th", "ih",
                                                       "E", "D", "SD", "HD", "h", "Om", "m", "A"}) &&
         (line[rec500Type + 2] == ' ' || isDigit(line[rec500Type + 2]));
}

}  // namespace

bool looksLikeNikonRaw(std::string_view beginning) {
  std::size_t comments = 0;
  bool hasStation = false, hasSighting = false;
  for (const std::string_view indented : contentLines(beginning)) {
    const std::string_view line = withoutIndent(indented);
    constexpr std::string_view heading = "CO,NIKON";
    if (upperCase(std::string(line.substr(0, heading.size()))) == heading) return true;
    comments += line.size() > 3 && line.starts_with("CO,") && isLatinLetter(line[3]) &&
                separatedParts(line, ',').size() == 2;
    constexpr std::size_t leastOfStation = 7;
    hasStation =
        hasStation || (line.starts_with("ST,") && separatedParts(line, ',').size() >= leastOfStation);
    hasSighting = hasSighting || isNikonSighting(line);
  }
  return hasSighting && (hasStation || comments >= 2);
}

bool looksLikeRw5(std::string_view beginning) {
  return std::ranges::any_of(contentLines(beginning), [](std::string_view indented) {
    const std::string_view line = withoutIndent(indented);
    constexpr std::size_t mark = 5;  // LS,HI
    const bool hasNumber = line.size() > mark && isDigit(line[mark]);
    return beginsWithMark(line, {"JB,NM", "OC,OP", "BK,OP", "SS,OP", "TR,OP", "BD,OP", "BR,OP", "FD,OP",
                                 "FR,OP", "GPS,PN"}) ||
           (hasNumber && beginsWithMark(line, {"MO,AD", "LS,HI"}));
  });
}

bool looksLikeGts6(std::string_view beginning) {
  const FieldLines lines = contentLines(beginning, 1);
  if (lines.empty()) return false;
  const std::string_view line = withoutIndent(lines[0]);
  return line.starts_with("_'") || line.find("_ ?+") != std::string_view::npos;
}

bool looksLikeGts7(std::string_view beginning) {
  std::set<std::string_view> words;
  std::size_t others = 0, withCommas = 0;
  for (const std::string_view indented : contentLines(beginning)) {
    const std::string_view line = withoutIndent(indented), word = gts7Word(line);
    others += word.empty() ? 1 : 0;
    withCommas += !word.empty() && line.find(',') != std::string_view::npos ? 1 : 0;
    words.insert(word);
  }
  const auto hasOneOf = [&words](std::initializer_list<std::string_view> wanted) {
    return std::ranges::any_of(wanted, [&words](std::string_view word) { return words.contains(word); });
  };
  return others <= 2 && withCommas >= 2 && hasOneOf({"JOB", "STN", "STA", "INST", "UNITS"}) &&
         hasOneOf({"STN", "STA", "BKB", "BS", "SS", "SC", "HV", "HVD", "SD", "HD"});
}

bool looksLikeGeodimeter(std::string_view beginning) {
  const FieldLines lines = contentLines(beginning);
  std::size_t values = 0;
  for (const std::string_view line : lines) {
    const std::size_t count = labelledValues(withoutIndent(line));
    if (count == 0) return false;
    values += count;
  }
  return values >= 2;
}

bool looksLikeTrimbleDc(std::string_view beginning) {
  const FieldLines lines = contentLines(beginning, 1);
  if (lines.empty() || hasSeparator(lines[0])) return false;
  const std::string_view line = withoutIndent(lines[0]);
  constexpr std::size_t shortest = 12, name = 4;
  if (line.size() < shortest) return false;
  if (line.starts_with("00NM"))
    return isLatinLetter(line[name]) && (line.find(':') != std::string_view::npos ||
                                         beginsWithMark(line.substr(name), {"SC V", "SCV", "DC10", "DC7"}));
  return beginsWithMark(line, {"10NM", "E0NM"}) && line.find('.') == std::string_view::npos;
}

bool looksLikeIdex(std::string_view beginning) {
  const FieldLines lines = contentLines(beginning);
  if (lines.empty() || hasSeparator(lines[0])) return false;
  const auto wordOf = [](std::string_view line) {
    const std::string_view content = withoutIndent(line);
    return content.substr(0, content.find_first_of(" \t"));
  };
  return wordOf(lines[0]) == "HEADER" && std::ranges::any_of(lines, [&wordOf](std::string_view line) {
           return isOneOf(wordOf(line), {"VERSION", "SYSTEM", "UNITS"});
         });
}

bool looksLikeRec500(std::string_view beginning) {
  const FieldLines lines = contentLines(beginning);
  return lines.size() >= 2 && hasRec500Address(lines[0]) && hasRec500Address(lines[1]) &&
         std::ranges::any_of(
             lines, [](std::string_view line) { return hasRec500Address(line) && hasRec500Value(line); });
}

bool looksLikeOtherZeiss(std::string_view beginning) {
  const FieldLines lines = contentLines(beginning, 1);
  if (lines.empty()) return false;
  const std::string_view line = withoutIndent(lines[0]);
  constexpr std::size_t longestMark = 7;
  const std::size_t bar = line.find('|');
  return beginsWithMark(line, {"For ", "For_"}) && bar > 4 && bar <= longestMark;
}

bool looksLikeGnss(std::string_view beginning) {
  const FieldLines lines = contentLines(beginning, 1);
  if (lines.empty()) return false;
  const std::string_view line = withoutIndent(lines[0]);
  return line.find("RINEX VERSION / TYPE") != std::string_view::npos ||
         beginsWithMark(line, {"$GP", "$GN", "$GL", "$GA", "$GB"});
}

}  // namespace alidade
