#include "ui/document/reading_column.h"

#include <array>
#include <string_view>

namespace alidade::ui {

namespace {

constexpr std::array<std::string_view, readingColumnCount> fieldNames = {
    "excluded", "point", "round", "face", "horizontal", "vertical", "slider", "", "", "note"};

}  // namespace

std::string Reading::*readingText(ReadingColumn column) {
  switch (column) {
    case ReadingColumn::Point:
      return &Reading::point;
    case ReadingColumn::Round:
      return &Reading::round;
    case ReadingColumn::Face:
      return &Reading::face;
    case ReadingColumn::Horizontal:
      return &Reading::horizontal;
    case ReadingColumn::Vertical:
      return &Reading::vertical;
    case ReadingColumn::Slider:
      return &Reading::slider;
    case ReadingColumn::Note:
      return &Reading::note;
    case ReadingColumn::Used:
    case ReadingColumn::HorizontalResidual:
    case ReadingColumn::VerticalResidual:
      break;
  }
  return nullptr;
}

std::string readingFieldName(ReadingColumn column) {
  return std::string(fieldNames.at(static_cast<std::size_t>(column)));
}

ReadingColumn readingColumn(const std::string& fieldName) {
  for (int column = 0; column < readingColumnCount; ++column) {
    const auto candidate = static_cast<ReadingColumn>(column);
    if (isEntered(candidate) && fieldNames.at(static_cast<std::size_t>(column)) == fieldName)
      return candidate;
  }
  return ReadingColumn::Horizontal;
}

bool isEntered(ReadingColumn column) {
  return column != ReadingColumn::HorizontalResidual && column != ReadingColumn::VerticalResidual;
}

std::string enteredText(const Reading& reading, ReadingColumn column) {
  if (column == ReadingColumn::Used) return reading.excluded ? "0" : "1";
  return reading.*readingText(column);
}

void enter(Reading& reading, ReadingColumn column, const std::string& text) {
  if (column == ReadingColumn::Used) {
    reading.excluded = text == "0";
  } else {
    reading.*readingText(column) = text;
  }
}

bool isBlank(const Reading& reading) {
  return reading.point.empty() && reading.round.empty() && reading.face.empty() &&
         reading.horizontal.empty() && reading.vertical.empty() && reading.slider.empty() &&
         reading.note.empty();
}

}  // namespace alidade::ui
