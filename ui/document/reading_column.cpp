#include "ui/document/reading_column.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cstddef>

namespace alidade::ui {

namespace {

constexpr std::array columns{
    ReadingColumnInfo{.column = ReadingColumn::Used,
                      .field = &rowField(&Reading::excluded),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Use"),
                      .toolTip = QT_TRANSLATE_NOOP("ReadingColumn",
                                                   "Rows without a tick are kept but excluded from the fit"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "use"),
                      .menuText = nullptr,
                      .widest = "Use",
                      .printedTitle = nullptr,
                      .printedWidth = 0},
    ReadingColumnInfo{.column = ReadingColumn::Point,
                      .field = &rowField(&Reading::point),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Point"),
                      .toolTip = QT_TRANSLATE_NOOP("ReadingColumn", "Number of the slider's place"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "point number"),
                      .menuText = nullptr,
                      .widest = "Point",
                      .printedTitle = QT_TRANSLATE_NOOP("ReadingColumn", "Point"),
                      .printedWidth = 10},
    ReadingColumnInfo{.column = ReadingColumn::Round,
                      .field = &rowField(&Reading::round),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Round"),
                      .toolTip = QT_TRANSLATE_NOOP("ReadingColumn", "Round of readings; empty means 1"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "round"),
                      .menuText = QT_TRANSLATE_NOOP("ReadingColumn", "&Round Column"),
                      .widest = "Round",
                      .printedTitle = QT_TRANSLATE_NOOP("ReadingColumn", "Round"),
                      .printedWidth = 11},
    ReadingColumnInfo{
        .column = ReadingColumn::Face,
        .field = &rowField(&Reading::face),
        .title = QT_TRANSLATE_NOOP("ReadingColumn", "Face"),
        .toolTip = QT_TRANSLATE_NOOP("ReadingColumn", "Face of the theodolite, 1 or 2; empty means 1"),
        .noun = QT_TRANSLATE_NOOP("ReadingColumn", "face"),
        .menuText = QT_TRANSLATE_NOOP("ReadingColumn", "&Face Column"),
        .widest = "Face",
        .printedTitle = QT_TRANSLATE_NOOP("ReadingColumn", "Face"),
        .printedWidth = 9},
    ReadingColumnInfo{.column = ReadingColumn::Horizontal,
                      .field = &rowField(&Reading::horizontal),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Horizontal α"),
                      .toolTip = QT_TRANSLATE_NOOP(
                          "ReadingColumn",
                          "Reading of the horizontal circle, degrees minutes seconds; 3415224 is 341°52′24″"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "horizontal reading"),
                      .menuText = nullptr,
                      .widest = nullptr,
                      .printedTitle = QT_TRANSLATE_NOOP("ReadingColumn", "Horizontal\nas read"),
                      .printedWidth = 26.5},
    ReadingColumnInfo{.column = ReadingColumn::Vertical,
                      .field = &rowField(&Reading::vertical),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Zenith β"),
                      .toolTip = QT_TRANSLATE_NOOP("ReadingColumn",
                                                   "Reading of the vertical circle, degrees minutes seconds"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "vertical reading"),
                      .menuText = nullptr,
                      .widest = nullptr,
                      .printedTitle = QT_TRANSLATE_NOOP("ReadingColumn", "Vertical\nas read"),
                      .printedWidth = 26.5},
    ReadingColumnInfo{.column = ReadingColumn::Slider,
                      .field = &rowField(&Reading::slider),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Slider s"),
                      .toolTip = QT_TRANSLATE_NOOP(
                          "ReadingColumn", "Slider coordinate at this sighting, degrees minutes seconds"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "slider reading"),
                      .menuText = QT_TRANSLATE_NOOP("ReadingColumn", "&Slider Column"),
                      .widest = nullptr,
                      .printedTitle = nullptr,
                      .printedWidth = 0},
    ReadingColumnInfo{.column = ReadingColumn::TiltCross,
                      .field = &rowField(&Reading::tiltCrossArcsec),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Tilt ⟂ ″"),
                      .toolTip = QT_TRANSLATE_NOOP("ReadingColumn",
                                                   "Tilt that the compensator read across the line of sight, "
                                                   "in arcseconds; positive if the axis leans right"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "cross tilt"),
                      .menuText = QT_TRANSLATE_NOOP("ReadingColumn", "Cross Tilt Column"),
                      .widest = "−188.88",
                      .printedTitle = nullptr,
                      .printedWidth = 0},
    ReadingColumnInfo{.column = ReadingColumn::TiltLength,
                      .field = &rowField(&Reading::tiltLengthArcsec),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Tilt ∥ ″"),
                      .toolTip = QT_TRANSLATE_NOOP("ReadingColumn",
                                                   "Tilt that the compensator read along the line of sight, "
                                                   "in arcseconds; positive if the axis leans forward"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "length tilt"),
                      .menuText = QT_TRANSLATE_NOOP("ReadingColumn", "Length Tilt Column"),
                      .widest = "−188.88",
                      .printedTitle = nullptr,
                      .printedWidth = 0},
    ReadingColumnInfo{.column = ReadingColumn::Corrections,
                      .field = &rowField(&Reading::corrections),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Corrections"),
                      .toolTip = QT_TRANSLATE_NOOP(
                          "ReadingColumn",
                          "Corrections that the instrument applied. Type inclination (compensator), "
                          "standing_axis (vertical axis), collimation, tilting_axis (trunnion axis) "
                          "or none; leave the cell empty if they are unknown"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "corrections"),
                      .menuText = QT_TRANSLATE_NOOP("ReadingColumn", "Corrections Column"),
                      .widest = "inclination none",
                      .printedTitle = nullptr,
                      .printedWidth = 0},
    ReadingColumnInfo{.column = ReadingColumn::TakenAt,
                      .field = &rowField(&Reading::takenAt),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Taken at"),
                      .toolTip = QT_TRANSLATE_NOOP(
                          "ReadingColumn", "When the instrument sent the reading, with the time zone"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "time of the reading"),
                      .menuText = QT_TRANSLATE_NOOP("ReadingColumn", "Time Column"),
                      .widest = "2026-08-28T08:08:08+08:00",
                      .printedTitle = nullptr,
                      .printedWidth = 0},
    ReadingColumnInfo{
        .column = ReadingColumn::ReturnCode,
        .field = &rowField(&Reading::returnCode),
        .title = QT_TRANSLATE_NOOP("ReadingColumn", "Code"),
        .toolTip = QT_TRANSLATE_NOOP("ReadingColumn",
                                     "GeoCOM return code of the angles; 0: the instrument confirms them"),
        .noun = QT_TRANSLATE_NOOP("ReadingColumn", "return code"),
        .menuText = QT_TRANSLATE_NOOP("ReadingColumn", "Return Code Column"),
        .widest = "Code 8",
        .printedTitle = nullptr,
        .printedWidth = 0},
    ReadingColumnInfo{.column = ReadingColumn::InstrumentSerial,
                      .field = &rowField(&Reading::instrumentSerial),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Serial No."),
                      .toolTip = QT_TRANSLATE_NOOP("ReadingColumn",
                                                   "Serial number of the instrument that sent the reading"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "instrument serial number"),
                      .menuText = QT_TRANSLATE_NOOP("ReadingColumn", "Serial Number Column"),
                      .widest = "Serial No.",
                      .printedTitle = nullptr,
                      .printedWidth = 0},
    ReadingColumnInfo{
        .column = ReadingColumn::HorizontalResidual,
        .field = nullptr,
        .title = QT_TRANSLATE_NOOP("ReadingColumn", "vα ″"),
        .toolTip = QT_TRANSLATE_NOOP(
            "ReadingColumn",
            "Residual of the horizontal reading in arcseconds: observed − adjusted, right positive"),
        .noun = nullptr,
        .menuText = nullptr,
        .widest = "−188.8",
        .printedTitle = nullptr,
        .printedWidth = 0},
    ReadingColumnInfo{.column = ReadingColumn::VerticalResidual,
                      .field = nullptr,
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "vβ ″"),
                      .toolTip = QT_TRANSLATE_NOOP(
                          "ReadingColumn",
                          "Residual of the vertical reading in arcseconds: observed − adjusted, up positive"),
                      .noun = nullptr,
                      .menuText = nullptr,
                      .widest = "−188.8",
                      .printedTitle = nullptr,
                      .printedWidth = 0},
    ReadingColumnInfo{.column = ReadingColumn::Note,
                      .field = &rowField(&Reading::note),
                      .title = QT_TRANSLATE_NOOP("ReadingColumn", "Note"),
                      .toolTip = QT_TRANSLATE_NOOP("ReadingColumn", "Free text"),
                      .noun = QT_TRANSLATE_NOOP("ReadingColumn", "note"),
                      .menuText = nullptr,
                      .widest = "Note",
                      .printedTitle = nullptr,
                      .printedWidth = 0},
};

constexpr bool isEachInItsPlace() {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].column != static_cast<ReadingColumn>(i)) return false;
  return columns.size() == readingColumnCount;
}
static_assert(isEachInItsPlace(), "one line for each ReadingColumn, in their order");

#ifndef __SANITIZE_ADDRESS__  // with AddressSanitizer, GCC 12 rejects constant address comparisons
static_assert(std::ranges::all_of(rowFields,
                                  [](const RowField& field) {
                                    return std::ranges::count(columns, &field, &ReadingColumnInfo::field) ==
                                           1;
                                  }),
              "each field of a row has its column");
#endif

}  // namespace

std::span<const ReadingColumnInfo> allReadingColumns() {
  return columns;
}

const ReadingColumnInfo& infoOf(ReadingColumn column) {
  return columns.at(static_cast<std::size_t>(column));
}

std::string Reading::*readingText(ReadingColumn column) {
  const RowField* field = infoOf(column).field;
  return field ? field->text : nullptr;
}

ReadingColumn readingColumn(const std::string& fieldName) {
  const RowField* field = rowFieldNamed(fieldName);
  return field ? std::ranges::find(columns, field, &ReadingColumnInfo::field)->column
               : ReadingColumn::Horizontal;
}

bool isAngle(ReadingColumn column) {
  const RowField* field = infoOf(column).field;
  return field && isAngle(*field);
}

bool isFreeText(ReadingColumn column) {
  const RowField* field = infoOf(column).field;
  return field && isFreeText(*field);
}

bool isEntered(ReadingColumn column) {
  return infoOf(column).field != nullptr;
}

std::string enteredText(const Reading& row, ReadingColumn column) {
  const auto text = readingText(column);
  return text ? row.*text : row.excluded ? "0" : "1";
}

void enter(Reading& row, ReadingColumn column, const std::string& text) {
  if (const auto own = readingText(column))
    row.*own = text;
  else
    row.excluded = text == "0";
}

}  // namespace alidade::ui
