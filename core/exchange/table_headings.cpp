#include "core/exchange/table_headings.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/exchange/heading_words.h"
#include "core/exchange/unread_rows.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

bool isNumberOrAngle(const std::string& cell) {
  return parseNumber(cell) || parseAngle(cell);
}

/// The part of an angle named by a heading without a circle: `min`, `(')`, `D`.
std::optional<AnglePart> partAlone(const std::string& heading) {
  const std::vector<std::string> words = headingWords(heading);
  if (words.size() == 1) {
    const std::string& word = words.front();
    if (isOneOf(word, {"d", "g"})) return AnglePart::Degrees;
    if (means(HeadingRole::MinutePart, word) || word == "c") return AnglePart::Minutes;
    if (means(HeadingRole::SecondPart, word) || word == "cc") return AnglePart::Seconds;
  }
  const ColumnName name = columnName(heading);
  if (!name.isUnderstood || name.column || !name.isPart) return std::nullopt;
  return name.part;
}

/// Separates the part: Hd means degrees and not a distance if Hm is among the names; likewise Vd with Vm.
std::string withItsPart(const std::string& name, const TableCells& names) {
  const std::string folded = foldedText(name);
  if (folded != "hd" && folded != "vd") return name;
  const std::string minutes = folded.substr(0, 1) + "m";
  const bool hasMinutes =
      std::ranges::any_of(names, [&](const std::string& other) { return foldedText(other) == minutes; });
  return hasMinutes ? name.substr(0, 1) + " d" : name;
}

/// Is this a row above the names, as `;Horizontal;;;Vertical` or `Face left;;Face right`, and not a title?
bool isRowAboveNames(const TableCells& cells) {
  bool isAny = false;
  for (const std::string& cell : cells) {
    if (cell.empty()) continue;
    if (isNumberOrAngle(cell)) return false;
    const ColumnName name = columnName(cell);
    isAny = isAny || (name.isUnderstood && ((name.column && name.column->isCircle()) || name.face > 0));
  }
  return isAny;
}

}  // namespace

bool isRowBelowNames(const TableCells& cells) {
  bool isAny = false;
  for (const std::string& cell : cells) {
    if (cell.empty()) continue;
    const ColumnName name = columnName(cell);
    const bool isFace = name.face > 0;
    if (isNumberOrAngle(cell) || (!isFace && hasAnyDigit(cell))) return false;
    const bool isUnit =
        name.isUnderstood && !name.column && (name.isPart || name.unit != AngleUnit::Unstated);
    const bool isBelow = isUnit || isFace || partAlone(cell);
    if (name.column && !isBelow) return false;
    isAny = isAny || isBelow;
  }
  return isAny;
}

bool isHeadingAboveNames(const TableCells& above, const TableCells& below) {
  return nameCircles(above) && !isRowBelowNames(below) && areColumnNames(below);
}

TableHeadings::TableHeadings(const std::vector<TableCells>& head, const std::vector<TableCells>& sample) {
  findLevels(head, sample);
  for (const TableCells& level : m_levels) m_width = std::max(m_width, level.size());
  findRuns();
}

void TableHeadings::findLevels(const std::vector<TableCells>& head, const std::vector<TableCells>& sample) {
  if (head.empty()) return;
  constexpr std::size_t mostBelow = 3;
  std::size_t names = head.size() - 1;
  while (names > 0 && isRowBelowNames(head[names]) && head.size() - names < mostBelow) --names;
  if (isRowBelowNames(head[names]) && names + 1 < head.size()) ++names;
  if (names > 0 && isRowAboveNames(head[names - 1])) m_levels.push_back(head[names - 1]);
  if (names > 1 && !m_levels.empty() && isRowAboveNames(head[names - 2]))
    m_levels.insert(m_levels.begin(), head[names - 2]);
  m_hasUpper = !m_levels.empty();
  m_levels.insert(m_levels.end(), head.begin() + static_cast<std::ptrdiff_t>(names), head.end());
  while (m_rowsBelow < std::min(sample.size(), mostBelow) && isRowBelowNames(sample[m_rowsBelow]))
    m_levels.push_back(sample[m_rowsBelow++]);
}

void TableHeadings::findRuns() {
  std::optional<AnglePart> before;
  for (std::size_t i = 0; i < m_width; ++i) {
    const auto part = partAlone(lowest(i, 0));
    const bool goesOn = part && before && !m_runs.empty() &&
                        static_cast<int>(*part) == static_cast<int>(*before) + 1 &&
                        m_runs.back().first + m_runs.back().count == i;
    if (goesOn)
      ++m_runs.back().count;
    else if (part == AnglePart::Degrees)
      m_runs.push_back({i, 1});
    before = part;
  }
  std::erase_if(m_runs, [](const Run& run) { return run.count < 2; });
}

std::string TableHeadings::cell(std::size_t level, std::size_t column) const {
  return column < m_levels[level].size() ? m_levels[level][column] : std::string();
}

/// The lowest text in the column, from row `from` on.
std::string TableHeadings::lowest(std::size_t column, std::size_t from) const {
  for (std::size_t level = m_levels.size(); level > from; --level)
    if (std::string text = cell(level - 1, column); !text.empty()) return text;
  return {};
}

/// May a heading above span this column, which must name a circle, a part or a face, but no other field?
bool TableHeadings::mayInherit(std::size_t column, std::size_t from) const {
  const std::string below = lowest(column, from);
  if (below.empty()) return false;
  const ColumnName name = columnName(below);
  return partAlone(below) || (name.isUnderstood && (!name.column || name.column->isCircle()));
}

/// The text of the cell; if it is empty, a text above the same run of parts, else the next text to the left.
std::string TableHeadings::spanned(std::size_t level, std::size_t column) const {
  std::string own = cell(level, column);
  if (!own.empty() || level + 1 == m_levels.size() || !mayInherit(column, level + 1)) return own;
  for (const Run& run : m_runs)
    if (column >= run.first && column < run.first + run.count)
      for (std::size_t i = run.first; i < run.first + run.count; ++i)
        if (std::string text = cell(level, i); !text.empty()) return text;
  for (std::size_t i = column; i > 0; --i)
    if (std::string text = cell(level, i - 1); !text.empty()) {
      const ColumnName name = columnName(text);
      const bool reaches = name.face > 0 || (name.column && name.column->isCircle());
      return reaches ? text : std::string();
    }
  return {};
}

std::string TableHeadings::writtenName(std::size_t column) const {
  std::string text;
  for (std::size_t level = 0; level < m_levels.size(); ++level) {
    const std::string own = spanned(level, column);
    if (!own.empty()) text += (text.empty() ? "" : " ") + own;
  }
  return text;
}

bool TableHeadings::isBlank(std::size_t column) const {
  return lowest(column, 0).empty();
}

ColumnName TableHeadings::nameOf(std::size_t column) const {
  std::string all, withoutUpper;
  for (std::size_t level = 0; level < m_levels.size(); ++level) {
    std::string text = spanned(level, column);
    if (text == cell(level, column)) text = withItsPart(text, m_levels[level]);
    if (text.empty()) continue;
    all += (all.empty() ? "" : " ") + text;
    const bool isUpper = m_hasUpper && level == 0;
    if (!isUpper) withoutUpper += (withoutUpper.empty() ? "" : " ") + text;
  }
  const ColumnName name = columnName(all);
  return name.isUnderstood || !m_hasUpper ? name : columnName(withoutUpper);
}

}  // namespace alidade
