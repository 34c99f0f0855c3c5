#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/phrase.h"
#include "core/session/entry.h"
#include "core/session/session.h"
#include "core/session/value_text.h"

namespace alidade {

// What a row consists of, said once: the session file, the checks of entries, the import of tables, the table
// in the window and the one in the report go through these fields.

inline constexpr WholeRule pointRule{
    0, std::numeric_limits<int>::max(), {}, PHRASE_LATER("Phrase", "%1 is no point: points count from 0")};
inline constexpr WholeRule roundRule{1, std::numeric_limits<int>::max(), 1,
                                     PHRASE_LATER("Phrase", "%1 is no round: rounds count from 1")};
inline constexpr WholeRule faceRule{1, 2, 1, PHRASE_LATER("Phrase", "%1 is no face: type 1 or 2")};

// Of the circles, for pointing zeros too.
inline constexpr AngleRule horizontalRule{.low = 0, .lowOfElevation = 0, .high = 360};
inline constexpr AngleRule verticalRule{.low = 0, .lowOfElevation = -90, .high = 360};
/// The slider turns both ways.
inline constexpr AngleRule sliderRule{
    .low = -360, .lowOfElevation = -360, .high = 360, .isHighIncluded = true, .mayBeEmpty = true};

struct FreeText {};
/// A number as a rule; whatever it says is kept, as nothing is computed from it.
struct NumberText {};
/// Arcseconds, by `tiltEntry`.
struct TiltRule {};
/// Words, by `correctionsEntry`.
struct CorrectionsRule {};

/// What a text of a row must be.
using RowRule = std::variant<FreeText, NumberText, WholeRule, AngleRule, TiltRule, CorrectionsRule>;

/// One field of a row: a text, or a flag.
struct RowField {
  std::string_view key;           ///< in the session file: "horizontal"
  std::string Reading::*text;     ///< null for a flag
  bool Reading::*flag = nullptr;  ///< null for a text
  RowRule rule;                   ///< of the text
  const char* remedy = nullptr;   ///< where a file lacks the field, for `Phrase::of`; null: it may be absent
};

/// In the order in which the session file has them.
inline constexpr std::array rowFields{
    RowField{.key = "point", .text = &Reading::point, .rule = pointRule},
    RowField{.key = "round", .text = &Reading::round, .rule = roundRule},
    RowField{.key = "face", .text = &Reading::face, .rule = faceRule},
    RowField{.key = "horizontal",
             .text = &Reading::horizontal,
             .rule = horizontalRule,
             .remedy = PHRASE_LATER("Phrase", "add the reading of the horizontal circle")},
    RowField{.key = "vertical",
             .text = &Reading::vertical,
             .rule = verticalRule,
             .remedy = PHRASE_LATER("Phrase", "add the reading of the vertical circle")},
    RowField{.key = "slider", .text = &Reading::slider, .rule = sliderRule},
    RowField{.key = "tilt_cross_arcsec", .text = &Reading::tiltCrossArcsec, .rule = TiltRule()},
    RowField{.key = "tilt_length_arcsec", .text = &Reading::tiltLengthArcsec, .rule = TiltRule()},
    RowField{.key = "corrections", .text = &Reading::corrections, .rule = CorrectionsRule()},
    RowField{.key = "taken_at", .text = &Reading::takenAt, .rule = FreeText()},
    RowField{.key = "return_code", .text = &Reading::returnCode, .rule = NumberText()},
    RowField{.key = "instrument_serial", .text = &Reading::instrumentSerial, .rule = FreeText()},
    RowField{.key = "excluded", .text = nullptr, .flag = &Reading::excluded, .rule = FreeText()},
    RowField{.key = "note", .text = &Reading::note, .rule = FreeText()},
};

constexpr const RowField& rowField(std::string Reading::*text) {
  return *std::ranges::find(rowFields, text, &RowField::text);
}
constexpr const RowField& rowField(bool Reading::*flag) {
  return *std::ranges::find(rowFields, flag, &RowField::flag);
}

/// By its name in the session file; null where no field has it.
constexpr const RowField* rowFieldNamed(std::string_view key) {
  const auto found = std::ranges::find(rowFields, key, &RowField::key);
  return found == rowFields.end() ? nullptr : &*found;
}

constexpr bool isAngle(const RowField& field) {
  return std::holds_alternative<AngleRule>(field.rule);
}
constexpr bool isFreeText(const RowField& field) {
  return field.text &&
         (std::holds_alternative<FreeText>(field.rule) || std::holds_alternative<NumberText>(field.rule));
}

/// How its text becomes JSON.
constexpr ValueKind kindOf(const RowField& field) {
  if (isAngle(field)) return ValueKind::Angle;
  const bool isNumber = std::holds_alternative<WholeRule>(field.rule) ||
                        std::holds_alternative<TiltRule>(field.rule) ||
                        std::holds_alternative<NumberText>(field.rule);
  return isNumber ? ValueKind::Number : ValueKind::Text;
}

/// What an empty text of the field stands for, as it would be typed: "1" for a round. Empty: for nothing.
std::string usualText(const RowField& field);

/// Why `text` cannot stand in the field of a row whose vertical circle is of that kind.
std::optional<Problem> entryProblem(const RowField& field, const std::string& text, VerticalCircle circle);

/// What a row tells of the compensator and of the corrections that were on.
inline constexpr std::string Reading::*compensatorTexts[] = {
    &Reading::tiltCrossArcsec, &Reading::tiltLengthArcsec, &Reading::corrections};
/// Does any row of the session?
bool tellsOfCompensator(const Session& session);

/// What came with a row from the instrument: when, with which return code, from which instrument.
inline constexpr std::string Reading::*arrivalTexts[] = {&Reading::takenAt, &Reading::returnCode,
                                                         &Reading::instrumentSerial};
/// The same of a pointing zero, in the same order.
inline constexpr std::string ZeroSighting::*zeroArrivalTexts[] = {
    &ZeroSighting::takenAt, &ZeroSighting::returnCode, &ZeroSighting::instrumentSerial};
/// Did anything come with any row of the session or with any pointing zero?
bool tellsOfArrival(const Session& session);

/// A sighting of a pointing zero, the first as the further ones are.
ZeroSighting firstSighting(const PointingZero& zero);

/// Is nothing typed in this row?
bool isBlank(const Reading& row);

}  // namespace alidade
