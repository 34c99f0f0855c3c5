#pragma once

#include <optional>
#include <string>
#include <vector>

namespace alidade {

/// The content on one subject, shared by console, window and report, which only lay it out. The texts are in
/// the language of the thread that made it.
struct Statement {
  struct Column {
    enum class Role {
      Name,    ///< what the row is about
      Word,    ///< a short word, such as a type
      Figure,  ///< a number with its unit
      Bar,     ///< a quantity with a bar of length `Row::bar`
      Text,    ///< words of any length, below the row
      Remark,  ///< shown only on demand if there is no room for it
    };

    std::string id;     ///< for tests and other programs: "share"
    std::string title;  ///< may be empty
    Role role = Role::Figure;
    std::string remark = {};  ///< explains the column; shown only on demand
  };

  struct Row {
    std::vector<std::string> cells;  ///< one for each column
    bool isTotal = false;            ///< a sum of the rows above
    bool isPart = false;             ///< a detail of the nearest row above that is not a part
    bool isNotable = false;          ///< highlighted, such as a closure that fails
    std::string id = {};             ///< what actions on the row refer to: "trunnion_tilt"
    std::string about = {};          ///< explains the row's name; shown on demand
    std::optional<double> bar = {};  ///< length of the bar in the column of this role, 0…1
  };

  std::string id;  ///< "budget_measured"
  std::string title;
  std::vector<Column> columns;  ///< the first is a Name
  std::vector<Row> rows;
  std::vector<std::string> sentences = {};
  std::string note = {};  ///< explains the columns

  /// The cells of a row that are shown below it, from columns with the role Text, each after the title of its
  /// column: "indistinguishable: gravity sag".
  std::vector<std::string> textsBelow(const Row& row) const;
};

/// Exchanges the rows and columns of a statement, for a narrow place. Details become remarks, each on a line:
/// "0° again: 16". `statement` has columns of names and figures only.
Statement transposed(const Statement& statement);

}  // namespace alidade
