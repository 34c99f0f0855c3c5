#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/finding.h"
#include "core/statement/statement.h"

namespace alidade::console {

/// The heading of a result: its name, always on one line.
std::string heading(std::string_view name);

/// Cells in columns, two blanks apart. The first column and the columns marked in `isLeft` are flush left,
/// the others flush right. Each line ends in a newline. Widths count code points; rows may differ in length.
std::string alignedColumns(const std::vector<std::vector<std::string>>& rows,
                           const std::vector<bool>& isLeft = {});

/// `text` with invisible characters escaped, broken at blanks into lines of at most `width` code points. The
/// text ends in a newline. Lines after the first begin with `indent` blanks. A word longer than a line gets a
/// line of its own.
std::string paragraph(std::string_view text, std::size_t indent = 0, std::size_t width = 100);

/// An empty line, the table under its title, the sentences and the note. Empty without rows and sentences.
std::string statementText(const Statement& statement);

/// An empty line and the block "Findings"; empty without findings.
std::string findingsText(const std::vector<Finding>& findings);

}  // namespace alidade::console
