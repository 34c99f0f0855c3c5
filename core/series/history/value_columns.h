#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace alidade {

/// The content of a column's first cell that is not blank.
struct ColumnContent {
  bool isDate = false, isNumber = false;
  bool hasUncertainty = false;  ///< the cell also holds the uncertainty, as 6.6743(15)
};

/// The columns of date, value and standard uncertainty, from 0; absent: there is none.
struct ValueColumns {
  std::optional<std::size_t> date, value, u;
  double factor = 1;   ///< the numbers of `u` are this many standard uncertainties
  std::string unit;    ///< from the brackets in the name of `value`; may be empty
  std::string remark;  ///< how the numbers of `u` are interpreted, if the name leaves a doubt; else empty
};

/// Finds the columns by their names, and by their contents if no name identifies them. Fails if several
/// columns could be the value or u, or if both state a unit, and not the same. `names`: empty if the table
/// has none.
Result<ValueColumns> valueColumns(const std::vector<std::string>& names,
                                  const std::vector<ColumnContent>& contents);

}  // namespace alidade
