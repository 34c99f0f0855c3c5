#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace alidade::console {

/// The heading of a result: a user's name for it, always on one line.
std::string heading(std::string_view name);

/// Cells in columns, two blanks apart: the first column and those that `isLeft` marks flush left, the others
/// flush right, each line ending in a newline. Widths are counted in code points; rows may differ in length.
std::string alignedColumns(const std::vector<std::vector<std::string>>& rows,
                           const std::vector<bool>& isLeft = {});

/// `text` with invisible characters escaped, broken at blanks into lines of at most `width` code points,
/// ending in a newline. Lines after the first begin with `indent` blanks. A longer word gets a line of its
/// own.
std::string paragraph(std::string_view text, std::size_t indent = 0, std::size_t width = 100);

}  // namespace alidade::console
