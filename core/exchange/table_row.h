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

/// The angle that the cells of a row make: `texts` of its degrees or all of it, its minutes and its seconds.
/// Empty where none has a text. Plain numbers are of the unit of the heading, else of `unit`.
Result<FileAngle> angleIn(const PlannedAngle& angle, const std::array<std::string, 3>& texts, AngleUnit unit);

/// How the cells of the column of faces call them; of a table without one, nothing.
FaceWords faceWordsIn(const TablePlan& plan, const std::vector<TableCells>& rows);

/// How often something was read otherwise than it is written, or left out: for one sentence each.
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
