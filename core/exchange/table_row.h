#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/angle_parts.h"
#include "core/exchange/table_faces.h"
#include "core/exchange/table_plan.h"

namespace alidade {

/// The angle in the cells of a row: `texts` of its degrees or the whole angle, its minutes and its seconds.
/// Empty if all are empty. Plain numbers have the unit of the heading, else `unit`.
Result<FileAngle> angleIn(const PlannedAngle& angle, const std::array<std::string, 3>& texts, AngleUnit unit);

/// The names of faces in the table's face column; empty without such a column.
FaceWords faceWordsIn(const TablePlan& plan, const std::vector<TableCells>& rows);

/// Counts texts that were interpreted or left out, for one sentence per kind.
class FileCounts {
 public:
  enum class Kind { Carried, FullCircle, Beyond };

  void add(Kind kind, std::size_t line);
  std::vector<std::string> sentences() const;

 private:
  struct Count {
    std::size_t count = 0, firstLine = 0;
  };
  std::array<Count, 3> m_counts{};
};

}  // namespace alidade
