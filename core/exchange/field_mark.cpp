#include "core/exchange/field_mark.h"

#include "core/exchange/words.h"

namespace alidade {

namespace {

/// Turns "000180" into "180", and "" into "0".
std::string withoutZeros(const std::string& digits) {
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos ? "0" : digits.substr(first);
}

bool isAllDigits(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

std::optional<FieldMark> fieldMark(std::string_view text, std::string_view more) {
  std::string plain = upperCase(std::string(text));
  std::erase_if(plain, [](char c) { return c == ' ' || c == '\t'; });
  const std::size_t digits = plain.find_last_not_of("0123456789") + 1;
  const std::string name = plain.substr(0, digits), own = plain.substr(digits);
  const std::string given = own.empty() ? std::string(more) : own, number = withoutZeros(given);
  const bool isTurn = isAllDigits(given) && (number == "0" || number == "180");
  const bool isAxis = name == "AXIS" || name == "POS" || name == "POSITION" || (name.empty() && !own.empty());
  if (isAxis && isTurn) return FieldMark{FieldMark::Kind::Axis, number};
  if (name == "ROUND" && isAllDigits(given)) return FieldMark{FieldMark::Kind::Round, number};
  if (name == "ZERO") return FieldMark{};
  return std::nullopt;
}

std::optional<std::string> stationMark(std::string_view text, std::string_view more) {
  const std::string plain = trimmed(text), large = upperCase(plain);
  for (const std::string_view word :
       {"STATION", "STANDPOINT", "STANDPUNKT", "SETUP", "STAT", "STN", "STP", "ST"}) {
    if (!large.starts_with(word)) continue;
    const std::size_t name = plain.find_first_not_of(" \t:=_-", word.size());
    if (name == std::string::npos) return withoutZeros(trimmed(more));
    // A longer word is not a mark, but a number may follow without a blank.
    const bool isParted = name > word.size() || isAllDigits(plain.substr(name));
    return isParted ? std::optional(plain.substr(name)) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace alidade
