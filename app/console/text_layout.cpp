#include "app/console/text_layout.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "core/base/visible_text.h"

namespace alidade::console {

namespace {

/// The number of UTF-8 code points: every byte except continuation bytes starts one.
std::size_t displayWidth(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::vector<std::size_t> columnWidths(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], displayWidth(row[i]));
  }
  return widths;
}

/// Reads the next word if it is a unit, which must stay on the line of its number; otherwise leaves the word.
bool peekUnit(std::istringstream& words, std::string& unit) {
  const std::istringstream::pos_type before = words.tellg();
  if (words >> unit && (unit.starts_with("mm") || unit.starts_with("%"))) return true;
  words.clear();
  words.seekg(before);
  return false;
}

using Role = Statement::Column::Role;

/// The indices of the columns in the table, in order, without `Text`. Remarks are last: they are longest.
std::vector<std::size_t> orderOf(const std::vector<Statement::Column>& columns) {
  std::vector<std::size_t> order, remarks;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].role != Role::Text) (columns[i].role == Role::Remark ? remarks : order).push_back(i);
  order.insert(order.end(), remarks.begin(), remarks.end());
  return order;
}

std::string tableText(const Statement& statement) {
  std::vector<std::vector<std::string>> rows{{statement.title}};
  std::vector<bool> isLeft;
  const std::vector<std::size_t> order = orderOf(statement.columns);
  for (const std::size_t i : order) {
    const Statement::Column& column = statement.columns[i];
    if (i > 0) rows.front().push_back(column.title);
    isLeft.push_back(column.role != Role::Figure);
  }
  for (const Statement::Row& row : statement.rows) {
    rows.emplace_back();
    for (const std::size_t i : order)
      rows.back().push_back((i > 0 ? "" : row.isPart ? "    " : "  ") + row.cells[i]);
  }
  std::istringstream lines(alignedColumns(rows, isLeft));
  std::string text, line;
  std::getline(lines, line);
  text = line + "\n";
  for (const Statement::Row& row : statement.rows) {
    std::getline(lines, line);
    text += line + "\n";
    for (const std::string& below : statement.textsBelow(row)) text += "    " + paragraph(below, 6);
  }
  return text;
}

std::string findingText(const Finding& finding) {
  std::string text = finding.severity == Severity::Note      ? "Note: "
                     : finding.severity == Severity::Warning ? "Warning: "
                                                             : "Error: ";
  const std::string place = finding.where.path();
  if (!place.empty()) text += place + ": ";
  text += finding.text;
  return "  " + paragraph(finding.remedy.empty() ? text : text + " " + finding.remedy, 4);
}

}  // namespace

std::string heading(std::string_view name) {
  return visibleText(name) + "\n";
}

std::string alignedColumns(const std::vector<std::vector<std::string>>& rows,
                           const std::vector<bool>& isLeft) {
  const std::vector<std::size_t> widths = columnWidths(rows);
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - displayWidth(row[i]), ' ');
      const bool left = i == 0 || (i < isLeft.size() && isLeft[i]);
      line += (i == 0 ? "" : "  ") + (left ? row[i] + blanks : blanks + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string paragraph(std::string_view text, std::size_t indent, std::size_t width) {
  std::istringstream words{visibleText(text)};
  std::string lines, word;
  std::size_t column = 0;
  while (words >> word) {
    for (std::string unit; peekUnit(words, unit);) word += " " + unit;
    if (column > 0 && column + 1 + displayWidth(word) > width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > 0) {
      lines += " ";
      ++column;
    }
    lines += word;
    column += displayWidth(word);
  }
  return lines + "\n";
}

std::string statementText(const Statement& statement) {
  if (statement.rows.empty() && statement.sentences.empty()) return "";
  std::string text = "\n" + (statement.rows.empty() ? statement.title + "\n" : tableText(statement));
  for (const std::string& sentence : statement.sentences) text += paragraph(sentence);
  return statement.note.empty() ? text : text + paragraph(statement.note);
}

std::string findingsText(const std::vector<Finding>& findings) {
  if (findings.empty()) return "";
  std::string text = "\nFindings\n";
  for (const Finding& finding : findings) text += findingText(finding);
  return text;
}

}  // namespace alidade::console
