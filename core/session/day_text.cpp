#include "core/session/time_text.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <optional>
#include <string_view>
#include <vector>

#include "core/session/entry.h"

namespace alidade {

namespace {

/// Digits or letters, with the separators before them.
struct DayPart {
  std::string before, text;
  bool isNumber = false;
};

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool isNumeral(char c) {
  return c >= '0' && c <= '9';
}

std::vector<DayPart> partsOf(const std::string& typed, std::string& rest) {
  std::vector<DayPart> parts;
  for (std::size_t i = 0; i < typed.size();) {
    if (!isLetter(typed[i]) && !isNumeral(typed[i])) {
      rest += typed[i++];
      continue;
    }
    const bool isNumber = isNumeral(typed[i]);
    DayPart part{rest, {}, isNumber};
    rest.clear();
    while (i < typed.size() && (isNumber ? isNumeral(typed[i]) : isLetter(typed[i]))) part.text += typed[i++];
    parts.push_back(part);
  }
  return parts;
}

/// The month, 1…12, of "Mar", "mar" or "March"; 0 for other texts.
int monthNamed(const std::string& text) {
  constexpr std::string_view names[] = {"january",   "february", "march",    "april",
                                        "may",       "june",     "july",     "august",
                                        "september", "october",  "november", "december"};
  std::string lower;
  for (const char c : text) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (lower == "sept") return 9;
  for (int i = 0; i < 12; ++i)
    if (lower == names[i] || (lower.size() == 3 && names[i].starts_with(lower))) return i + 1;
  return 0;
}

std::optional<std::string> dayOf(const std::string& year, int month, const std::string& day) {
  if (year.size() != 4 || day.empty() || day.size() > 2) return std::nullopt;
  char text[16];
  std::snprintf(text, sizeof text, "%s-%02d-%02d", year.c_str(), month, std::stoi(day));
  return dateProblem(text) ? std::nullopt : std::optional<std::string>(text);
}

int monthOf(const DayPart& part) {
  if (!part.isNumber) return monthNamed(part.text);
  return part.text.size() <= 2 ? std::stoi(part.text) : 0;
}

bool isGap(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return c == ' ' || c == '.' || c == ',' || c == '-'; });
}

std::optional<std::string> withName(const std::vector<DayPart>& parts) {
  if (!isGap(parts[1].before) || !isGap(parts[2].before)) return std::nullopt;
  if (!parts[1].isNumber) {
    if (auto day = dayOf(parts[2].text, monthOf(parts[1]), parts[0].text)) return day;
    return dayOf(parts[0].text, monthOf(parts[1]), parts[2].text);
  }
  return parts[0].isNumber ? std::nullopt : dayOf(parts[2].text, monthOf(parts[0]), parts[1].text);
}

std::string withoutBlanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

std::optional<std::string> inNumbers(const std::vector<DayPart>& parts, const std::string& rest) {
  const std::string first = withoutBlanks(parts[1].before), second = withoutBlanks(parts[2].before);
  if (first == "年" && second == "月" && (rest == "日" || rest.empty()))
    return dayOf(parts[0].text, monthOf(parts[1]), parts[2].text);
  const bool isKnown = first == second && (first == "." || first == "/" || first == "-");
  if (!isKnown || (!rest.empty() && rest != ".")) return std::nullopt;
  if (parts[0].text.size() == 4) return dayOf(parts[0].text, monthOf(parts[1]), parts[2].text);
  const auto dayFirst = dayOf(parts[2].text, monthOf(parts[1]), parts[0].text);
  if (first == ".") return dayFirst;
  const auto monthFirst = dayOf(parts[2].text, monthOf(parts[0]), parts[1].text);
  if (dayFirst && monthFirst && dayFirst != monthFirst) return std::nullopt;
  return dayFirst ? dayFirst : monthFirst;
}

}  // namespace

std::string completedDay(const std::string& typed) {
  std::string rest;
  const std::vector<DayPart> parts = partsOf(typed, rest);
  if (parts.size() == 1 && parts[0].isNumber && typed.size() == 8)
    return dayOf(typed.substr(0, 4), std::stoi(typed.substr(4, 2)), typed.substr(6)).value_or(typed);
  if (parts.size() != 3 || !withoutBlanks(parts[0].before).empty()) return typed;
  const bool hasName = std::ranges::any_of(parts, [](const DayPart& part) { return !part.isNumber; });
  if (hasName) return withoutBlanks(rest).empty() ? withName(parts).value_or(typed) : typed;
  return inNumbers(parts, withoutBlanks(rest)).value_or(typed);
}

bool isDay(std::string_view key) {
  return key.ends_with("_on") || key.ends_with(".date");
}

}  // namespace alidade
