#include "app/console/statement_text.h"

#include <sstream>
#include <vector>

#include "app/console/text_layout.h"

namespace alidade::console {

namespace {

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

}  // namespace

std::string statementText(const Statement& statement) {
  if (statement.rows.empty() && statement.sentences.empty()) return "";
  std::string text = "\n" + (statement.rows.empty() ? statement.title + "\n" : tableText(statement));
  for (const std::string& sentence : statement.sentences) text += paragraph(sentence);
  return statement.note.empty() ? text : text + paragraph(statement.note);
}

}  // namespace alidade::console
