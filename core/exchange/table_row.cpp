#include "core/exchange/table_row.h"

#include <algorithm>

#include "core/base/phrase.h"

namespace alidade {

Result<FileAngle> angleIn(const PlannedAngle& angle, const std::array<std::string, 3>& texts,
                          AngleUnit unit) {
  if (std::ranges::all_of(texts, &std::string::empty)) return FileAngle{};
  const bool isCircle = angle.field->remedy != nullptr;
  if (angle.isJoined()) {
    const bool hasSeconds = angle.at[2] != PlannedAngle::none;
    return joinedAngle({texts[0], texts[1], texts[2]}, hasSeconds, angle.isCentesimal);
  }
  std::string text = withUnit(texts[0], angle.unit == AngleUnit::Unstated ? unit : angle.unit);
  return isCircle ? angleOfFile(std::move(text)) : FileAngle{.text = std::move(text)};
}

FaceWords faceWordsIn(const TablePlan& plan, const std::vector<TableCells>& rows) {
  FaceWords words;
  for (std::size_t i = 0; i < plan.columns.size(); ++i) {
    const ColumnName& name = plan.columns[i];
    if (!name.column || !name.column->isOf(&Reading::face)) continue;
    std::vector<std::string> cells;
    for (const TableCells& row : rows)
      if (i < row.size()) cells.push_back(row[i]);
    words = FaceWords(cells, name.isSpanish);
  }
  return words;
}

void FileCounts::add(Kind kind, std::size_t line) {
  Count& count = m_counts[static_cast<std::size_t>(kind)];
  if (count.count++ == 0) count.firstLine = line;
}

std::vector<std::string> FileCounts::sentences() const {
  std::vector<std::string> sentences;
  const auto& [carried, full, beyond] = m_counts;
  if (carried.count > 0)
    sentences.push_back(Phrase::of(
        "minutes or seconds of 60 carry to the next degree or minute: %1 in all, the first in line %2",
        carried.count, carried.firstLine));
  if (full.count > 0)
    sentences.push_back(
        Phrase::of("a full circle is taken as the zero of the circle: %1 in all, the first in line %2",
                   full.count, full.firstLine));
  if (beyond.count > 0)
    sentences.push_back(
        Phrase::of("texts beyond the last named column are not used: %1 in all, the first in line %2",
                   beyond.count, beyond.firstLine));
  return sentences;
}

}  // namespace alidade
