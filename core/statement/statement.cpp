#include "core/statement/statement.h"

#include <utility>

#include "core/base/phrase.h"

namespace alidade {

namespace {

/// The remark on a column: its own, then the details of its rows.
std::string remarkOf(const Statement& statement, std::size_t column) {
  std::string remark = statement.columns[column].remark;
  for (const Statement::Row& row : statement.rows)
    if (row.isPart && !row.cells[column].empty())
      remark += (remark.empty() ? "" : "\n") + row.cells.front() + ": " + row.cells[column];
  return remark;
}

}  // namespace

std::vector<std::string> Statement::textsBelow(const Row& row) const {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    if (columns[i].role != Column::Role::Text || row.cells[i].empty()) continue;
    if (columns[i].title.empty())
      texts.push_back(row.cells[i]);
    else
      //: title of a column and its cell: "indistinguishable: gravity sag"
      texts.push_back(Phrase::of("%1: %2", columns[i].title, row.cells[i]));
  }
  return texts;
}

Statement transposed(const Statement& statement) {
  using Role = Statement::Column::Role;
  Statement turned{.id = statement.id,
                   .title = statement.title,
                   .columns = {statement.columns.front()},
                   .rows = {},
                   .sentences = statement.sentences,
                   .note = statement.note};
  if (statement.rows.empty()) return turned;
  for (std::size_t i = 1; i < statement.columns.size(); ++i)
    turned.rows.push_back({{statement.columns[i].title}});
  for (const Statement::Row& row : statement.rows) {
    if (row.isPart) continue;
    turned.columns.push_back({std::to_string(turned.columns.size()), row.cells.front()});
    for (std::size_t i = 1; i < row.cells.size(); ++i) turned.rows[i - 1].cells.push_back(row.cells[i]);
  }
  turned.columns.push_back({"remark", "", Role::Remark});
  for (std::size_t i = 1; i < statement.columns.size(); ++i)
    turned.rows[i - 1].cells.push_back(remarkOf(statement, i));
  return turned;
}

}  // namespace alidade
