#include "core/statement/statement.h"

#include "core/base/phrase.h"

namespace alidade {

std::vector<std::string> Statement::textsBelow(const Row& row) const {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < row.cells.size(); ++i)
    if (columns[i].role == Column::Role::Text && !row.cells[i].empty())
      //: title of a column and its cell: "cannot be told from: gravity sag"
      texts.push_back(Phrase::of("%1: %2", columns[i].title, row.cells[i]));
  return texts;
}

}  // namespace alidade
