#include "core/exchange/joined_table.h"

#include <algorithm>
#include <utility>

#include "core/exchange/table_row.h"

namespace alidade {

namespace {

/// The parts unchanged, separated by blanks: the text of parts that do not form an angle.
std::string sideBySide(const std::array<std::string, 3>& parts) {
  std::string text = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (!parts[i].empty()) text += " " + parts[i];
  return text;
}

/// Joins the rows below the headings.
class TableJoiner {
 public:
  TableJoiner(TablePlan plan, std::vector<TableCells> readings)
      : m_plan(std::move(plan)), m_readings(std::move(readings)), m_faces(faceWordsIn(m_plan, m_readings)) {}

  JoinedTable joined() {
    takeColumns();
    for (const TableCells& row : m_readings)
      for (const bool isFaceTwo : {false, true})
        if (!isFaceTwo || (m_plan.hasBothFaces && hasFaceTwo(row)))
          m_joined.rows.push_back(joinedRow(row, isFaceTwo));
    return std::move(m_joined);
  }

 private:
  void takeColumns() {
    const TableColumn face{.field = &rowField(&Reading::face)};
    bool hasFace = false;
    for (std::size_t i = 0; i < m_plan.columns.size(); ++i) {
      const auto& column = m_plan.columns[i].column;
      if (!column && !m_plan.names[i].empty()) m_joined.unplaced.push_back(m_plan.names[i]);
      const bool isPart = column && (column->part != AnglePart::Degrees || column->isFaceTwo);
      if (!column || isPart) continue;
      hasFace = hasFace || column == face;
      m_joined.columns.push_back(*column);
      m_joined.names.push_back(m_plan.names[i]);
      m_sources.push_back(i);
    }
    if (hasFace || (!m_plan.hasBothFaces && m_plan.face == 0)) return;
    m_joined.columns.push_back(face);
    m_joined.names.emplace_back();
    m_sources.push_back(PlannedAngle::none);
  }

  const PlannedAngle* angleOf(const TableColumn& column, bool isFaceTwo) const {
    const auto found = std::ranges::find_if(m_plan.angles, [&](const PlannedAngle& angle) {
      return angle.field == column.field && angle.isFaceTwo == (isFaceTwo && column.isCircle());
    });
    return found == m_plan.angles.end() ? nullptr : &*found;
  }

  static std::array<std::string, 3> textsOf(const PlannedAngle& angle, const TableCells& row) {
    std::array<std::string, 3> texts;
    for (std::size_t part = 0; part < texts.size(); ++part)
      if (angle.at[part] < row.size()) texts[part] = row[angle.at[part]];
    return texts;
  }

  bool hasFaceTwo(const TableCells& row) const {
    return std::ranges::any_of(m_plan.angles, [&](const PlannedAngle& angle) {
      return angle.isFaceTwo && !sideBySide(textsOf(angle, row)).empty();
    });
  }

  TableCells joinedRow(const TableCells& row, bool isFaceTwo) const {
    TableCells cells;
    for (std::size_t i = 0; i < m_joined.columns.size(); ++i) {
      const TableColumn& column = m_joined.columns[i];
      const bool isFace = column.isOf(&Reading::face);
      const std::size_t at = m_sources[i];
      const std::string text = at < row.size() ? row[at] : std::string();
      if (const PlannedAngle* angle = angleOf(column, isFaceTwo)) {
        const std::array<std::string, 3> texts = textsOf(*angle, row);
        const auto read =
            angle->isJoined() ? angleIn(*angle, texts, AngleUnit::Unstated) : Result<FileAngle>(Problem{});
        cells.push_back(read                ? read->text
                        : angle->isJoined() ? sideBySide(texts)
                                            : withUnit(texts[0], angle->unit));
      } else if (isFace && m_plan.hasBothFaces) {
        cells.emplace_back(isFaceTwo ? "2" : "1");
      } else if (isFace && at == PlannedAngle::none) {
        cells.push_back(std::to_string(m_plan.face));
      } else {
        cells.push_back(isFace ? m_faces.of(text) : text);
      }
    }
    return cells;
  }

  TablePlan m_plan;
  std::vector<TableCells> m_readings;
  FaceWords m_faces;
  std::vector<std::size_t> m_sources;  ///< source columns in the rows
  JoinedTable m_joined;
};

}  // namespace

std::optional<Result<JoinedTable>> joinedTable(const std::vector<TableCells>& rows) {
  if (rows.size() < 2 || !areColumnNames(rows.front())) return std::nullopt;
  const bool isAbove = rows.size() > 2 && isHeadingAboveNames(rows[0], rows[1]);
  const auto names = rows.begin() + (isAbove ? 2 : 1);
  TableLayout layout;
  layout.needsVertical = false;
  layout.needsCircles = false;
  TablePlan plan = planTable({rows.begin(), names}, {names, rows.end()}, layout);
  if (plan.problem) return Problem{*plan.problem};
  std::vector<TableCells> readings(names + static_cast<std::ptrdiff_t>(plan.rowsBelow), rows.end());
  return Result<JoinedTable>(TableJoiner(std::move(plan), std::move(readings)).joined());
}

}  // namespace alidade
