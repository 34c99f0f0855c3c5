#include "core/session/row_fields.h"

#include <cstddef>
#include <type_traits>

namespace alidade {

namespace {

/// Converts to any type.
struct Anything {
  template <typename Value>
  operator Value() const;
};

/// The number of members of a plain struct: the largest number of initialisers it accepts.
template <typename Struct, typename... Members>
constexpr std::size_t memberCount() {
  if constexpr (requires { Struct{Members()..., Anything()}; })
    return memberCount<Struct, Members..., Anything>();
  else
    return sizeof...(Members);
}

static_assert(memberCount<Reading>() == rowFields.size() + 2,
              "each member of a row but its origin and first texts has its line in rowFields");
static_assert(std::ranges::all_of(rowFields,
                                  [](const RowField& field) { return !field.text != !field.flag; }));

template <typename Owner, typename Texts>
bool hasAny(const Owner& owner, const Texts& texts) {
  return std::ranges::any_of(texts, [&owner](const auto text) { return !(owner.*text).empty(); });
}

std::optional<Problem> ruleProblem(const FreeText&, const std::string&, VerticalCircle) {
  return std::nullopt;
}

std::optional<Problem> ruleProblem(const NumberText&, const std::string&, VerticalCircle) {
  return std::nullopt;
}

std::optional<Problem> ruleProblem(const WholeRule& rule, const std::string& text, VerticalCircle) {
  const auto entry = wholeEntry(rule, text);
  return entry ? std::nullopt : std::optional(entry.problem());
}

std::optional<Problem> ruleProblem(const AngleRule& rule, const std::string& text, VerticalCircle circle) {
  const auto entry = angleEntry(rule, text, circle);
  return entry ? std::nullopt : std::optional(entry.problem());
}

std::optional<Problem> ruleProblem(const TiltRule&, const std::string& text, VerticalCircle) {
  const auto entry = tiltEntry(text);
  return entry ? std::nullopt : std::optional(entry.problem());
}

std::optional<Problem> ruleProblem(const CorrectionsRule&, const std::string& text, VerticalCircle) {
  const auto entry = correctionsEntry(text);
  return entry ? std::nullopt : std::optional(entry.problem());
}

}  // namespace

std::string usualText(const RowField& field) {
  const auto* rule = std::get_if<WholeRule>(&field.rule);
  return rule && rule->fallback ? std::to_string(*rule->fallback) : std::string();
}

std::optional<Problem> entryProblem(const RowField& field, const std::string& text, VerticalCircle circle) {
  return std::visit([&](const auto& rule) { return ruleProblem(rule, text, circle); }, field.rule);
}

bool hasCompensatorTexts(const Session& session) {
  for (const Position& position : session.positions)
    for (const Reading& row : position.readings)
      if (hasAny(row, compensatorTexts)) return true;
  return false;
}

bool hasArrivalTexts(const Session& session) {
  for (const Position& position : session.positions) {
    if (hasAny(firstSighting(position.zero), zeroArrivalTexts)) return true;
    for (const ZeroSlot& slot : furtherZeros)
      if (hasAny(position.zero.*slot.sighting, zeroArrivalTexts)) return true;
    for (const Reading& row : position.readings)
      if (hasAny(row, arrivalTexts)) return true;
  }
  return false;
}

ZeroSighting firstSighting(const PointingZero& zero) {
  ZeroSighting first{zero.horizontal, zero.vertical};
  first.takenAt = zero.takenAt;
  first.returnCode = zero.returnCode;
  first.instrumentSerial = zero.instrumentSerial;
  return first;
}

bool isBlank(const Reading& row) {
  return std::ranges::all_of(rowFields,
                             [&](const RowField& field) { return !field.text || (row.*field.text).empty(); });
}

}  // namespace alidade
