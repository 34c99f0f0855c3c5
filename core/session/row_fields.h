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

// The fields of a row, defined once for all uses: the session file, the checks of entries, the import of
// tables, and the tables of window and report.

inline constexpr WholeRule pointRule{0,
                                     std::numeric_limits<int>::max(),
                                     {},
                                     PHRASE_LATER("Phrase", "%1 is no point: points are numbered from 0")};
inline constexpr WholeRule roundRule{1, std::numeric_limits<int>::max(), 1,
                                     PHRASE_LATER("Phrase", "%1 is no round: rounds are numbered from 1")};
inline constexpr WholeRule faceRule{1, 2, 1, PHRASE_LATER("Phrase", "%1 is no face: type 1 or 2")};

// Rules of the circles, for pointing zeros too.
inline constexpr AngleRule horizontalRule{.low = 0, .lowOfElevation = 0, .high = 360};
inline constexpr AngleRule verticalRule{.low = 0, .lowOfElevation = -90, .high = 360};
/// The slider turns in both directions.
inline constexpr AngleRule sliderRule{
    .low = -360, .lowOfElevation = -360, .high = 360, .isHighIncluded = true, .mayBeEmpty = true};

/// Any number; it is kept as typed, as no calculation uses it.
struct NumberText {};
/// Arcseconds that `tiltEntry` accepts.
struct TiltRule {};
/// Words that `correctionsEntry` accepts.
struct CorrectionsRule {};

/// The rule for a text of a row.
using RowRule = std::variant<FreeText, NumberText, WholeRule, AngleRule, TiltRule, CorrectionsRule>;

/// One field of a row: a text, or a flag.
struct RowField {
  std::string_view key;           ///< in the session file: "horizontal"
  std::string Reading::*text;     ///< null for a flag
  bool Reading::*flag = nullptr;  ///< null for a text
  RowRule rule;                   ///< rule for the text
  const char* remedy = nullptr;   ///< what to do if a file lacks the field; null: optional
};

/// All fields in the order of the session file.
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

/// The field by its name in the session file; null if there is none.
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

/// The JSON notation of the field's text.
constexpr ValueKind kindOf(const RowField& field) {
  if (isAngle(field)) return ValueKind::Angle;
  const bool isNumber = std::holds_alternative<WholeRule>(field.rule) ||
                        std::holds_alternative<TiltRule>(field.rule) ||
                        std::holds_alternative<NumberText>(field.rule);
  return isNumber ? ValueKind::Number : ValueKind::Text;
}
/// The JSON notation of a field by its name in the session file; text if the name is unknown.
constexpr ValueKind kindOfCell(std::string_view key) {
  const RowField* field = rowFieldNamed(key);
  return field ? kindOf(*field) : ValueKind::Text;
}

/// The text that an empty text of the field stands for: "1" for a round. Empty if there is none.
std::string usualText(const RowField& field);

/// Returns the reason why `text` is invalid in the field of a row with this kind of vertical circle.
std::optional<Problem> entryProblem(const RowField& field, const std::string& text, VerticalCircle circle);

/// The texts of a row on the compensator and the corrections that were on.
inline constexpr std::string Reading::*compensatorTexts[] = {
    &Reading::tiltCrossArcsec, &Reading::tiltLengthArcsec, &Reading::corrections};
/// Does any row of the session have one of the `compensatorTexts`?
bool hasCompensatorTexts(const Session& session);

/// The texts of a row that record its arrival from an instrument: time, return code, serial number.
inline constexpr std::string Reading::*arrivalTexts[] = {&Reading::takenAt, &Reading::returnCode,
                                                         &Reading::instrumentSerial};
/// The same texts of a pointing zero, in the same order.
inline constexpr std::string ZeroSighting::*zeroArrivalTexts[] = {
    &ZeroSighting::takenAt, &ZeroSighting::returnCode, &ZeroSighting::instrumentSerial};
/// Does any row of the session have one of the `arrivalTexts`, or a pointing zero one of `zeroArrivalTexts`?
bool hasArrivalTexts(const Session& session);

/// The first sighting of a pointing zero in the form of the further ones.
ZeroSighting firstSighting(const PointingZero& zero);

/// Is nothing typed in this row?
bool isBlank(const Reading& row);

}  // namespace alidade
