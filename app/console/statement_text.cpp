#include "app/console/statement_text.h"

#include <vector>

#include "app/console/text_layout.h"

namespace alidade::console {

namespace {

/// The remarks stand at the end, since they are the longest.
std::vector<std::string> inOrder(const Statement& statement, const std::vector<std::string>& cells) {
  std::vector<std::string> row, remarks;
  for (std::size_t i = 0; i < cells.size(); ++i)
    (statement.columns[i].role == Statement::Column::Role::Remark ? remarks : row).push_back(cells[i]);
  row.insert(row.end(), remarks.begin(), remarks.end());
  return row;
}

}  // namespace

std::string statementText(const Statement& statement) {
  std::vector<std::string> head{statement.title};
  for (std::size_t i = 1; i < statement.columns.size(); ++i) head.push_back(statement.columns[i].title);
  std::vector<std::vector<std::string>> rows{inOrder(statement, head)};
  for (const Statement::Row& row : statement.rows) {
    rows.push_back(inOrder(statement, row.cells));
    rows.back().front().insert(0, "  ");
  }
  std::string text = "\n" + alignedColumns(rows);
  for (const std::string& sentence : statement.sentences) text += paragraph(sentence);
  return statement.note.empty() ? text : text + paragraph(statement.note);
}

}  // namespace alidade::console
