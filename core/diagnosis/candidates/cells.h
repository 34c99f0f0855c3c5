#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace alidade {

/// A cell is a run of consecutive readings with the same property. Cells are numbered from 0 in the order of
/// the readings.
struct Cells {
  // 32 bits suffice: `limits::mostRows` bounds the number of rows.
  std::vector<std::uint32_t> ofReadings;  ///< the cell of each reading
  std::vector<std::uint32_t> readings;    ///< the first reading of each cell

  /// `same(i, i + 1)` returns whether the two readings share a cell.
  template <typename Same>
  Cells(Eigen::Index count, const Same& same) {
    ofReadings.reserve(static_cast<std::size_t>(count));
    for (Eigen::Index i = 0; i < count; ++i) {
      if (i == 0 || !same(i - 1, i)) readings.push_back(static_cast<std::uint32_t>(i));
      ofReadings.push_back(static_cast<std::uint32_t>(readings.size() - 1));
    }
  }

  Eigen::Index count() const { return static_cast<Eigen::Index>(readings.size()); }
  Eigen::Index readingOf(Eigen::Index cell) const { return readings[static_cast<std::size_t>(cell)]; }
  /// Returns the value of `valueOf` for the first reading of each cell.
  template <typename Value>
  Eigen::VectorXd values(const Value& valueOf) const {
    return Eigen::VectorXd::NullaryExpr(count(), [&](Eigen::Index cell) { return valueOf(readingOf(cell)); });
  }
};

}  // namespace alidade
