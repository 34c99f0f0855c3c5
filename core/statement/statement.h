#pragma once

#include <string>
#include <vector>

namespace alidade {

/// What is told of one subject, once for console, window and report. The texts are in the language of the
/// thread that made it. Each place only lays it out.
struct Statement {
  struct Column {
    enum class Role {
      Name,    ///< what the row is about
      Word,    ///< a short word, such as a type
      Figure,  ///< a number with its unit
      Remark,  ///< a place without room for it shows it on demand
    };

    std::string id;     ///< for tests and other programs: "share"
    std::string title;  ///< may be empty
    Role role = Role::Figure;
  };

  struct Row {
    std::vector<std::string> cells;  ///< one for each column
    bool isTotal = false;            ///< a sum of the rows above
  };

  std::string id;  ///< "budget_measured"
  std::string title;
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::vector<std::string> sentences = {};
  std::string note = {};  ///< explains the columns
};

}  // namespace alidade
