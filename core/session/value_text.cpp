#include "core/session/value_text.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "core/base/number_text.h"
#include "core/base/phrase.h"

namespace alidade {

namespace {

/// The shortest text without an exponent, which angles may not have, that reads back as the same double.
std::string plainDecimal(double value) {
  char text[1100];  // room for the smallest and the largest double
  const auto result = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
  return {text, result.ptr};
}

}  // namespace

std::optional<std::string> textOf(const nlohmann::ordered_json& value, ValueKind kind) {
  if (value.is_string()) return value.get_ref<const std::string&>();
  if (!value.is_number() || kind == ValueKind::Text) return std::nullopt;
  const bool angle = kind == ValueKind::Angle;
  const std::string unit = angle ? "°" : "";
  if (value.is_number_unsigned()) return std::to_string(value.get<std::uint64_t>()) + unit;
  if (value.is_number_integer()) return std::to_string(value.get<std::int64_t>()) + unit;
  const double number = value.get<double>();
  return (angle ? plainDecimal(number) : shortestText(number)) + unit;
}

nlohmann::ordered_json valueOf(const std::string& text, ValueKind kind) {
  if (kind != ValueKind::Number) return text;
  const Result<double> number = parseNumber(text);
  if (!number) return text;
  constexpr double largestExactInteger = 9007199254740992.0;
  const bool integer = std::trunc(*number) == *number && std::abs(*number) <= largestExactInteger;
  if (integer) return static_cast<std::int64_t>(*number);
  return *number;
}

std::string filedText(const std::string& text, ValueKind kind) {
  return text.empty() ? text : textOf(valueOf(text, kind), kind).value_or(text);
}

std::vector<std::string> entriesOf(const nlohmann::ordered_json& list) {
  std::vector<std::string> texts;
  for (const auto& member : list)
    texts.push_back(member.is_string() ? member.get<std::string>() : member.dump());
  return texts;
}

std::string wantedType(ValueKind kind) {
  switch (kind) {
    case ValueKind::Text:
      return Phrase::of("a text in quotation marks");
    case ValueKind::Number:
      return Phrase::of("a number");
    case ValueKind::Angle:
      return Phrase::of("an angle, a text such as \"341 52 24\" or a number of degrees");
  }
  return {};
}

}  // namespace alidade
