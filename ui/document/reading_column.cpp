#include "ui/document/reading_column.h"

#include <array>

namespace alidade::ui {

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
  static constexpr std::array<const char*, readingColumnCount> names = {
      "excluded", "point", "round", "face", "horizontal", "vertical", "slider", "", "", "note"};
  return names.at(static_cast<std::size_t>(column));
}

ReadingColumn readingColumn(const std::string& fieldName) {
  for (int column = 0; column < readingColumnCount; ++column) {
    const auto candidate = static_cast<ReadingColumn>(column);
    if (isEntered(candidate) && readingFieldName(candidate) == fieldName) return candidate;
  }
  return ReadingColumn::Horizontal;
}

bool isEntered(ReadingColumn column) {
  return column != ReadingColumn::HorizontalResidual && column != ReadingColumn::VerticalResidual;
}

bool isBlank(const Reading& reading) {
  return reading.point.empty() && reading.round.empty() && reading.face.empty() &&
         reading.horizontal.empty() && reading.vertical.empty() && reading.slider.empty() &&
         reading.note.empty();
}

}  // namespace alidade::ui
