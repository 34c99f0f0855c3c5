#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace alidade {

// Readings that have something in common.

/// Neighbours that are the same in some respect are a cell, numbered from 0 in the order of the readings.
struct Cells {
  // There are no more rows than `limits::mostRows`.
  std::vector<std::uint32_t> ofReadings;  ///< the cell of each reading
  std::vector<std::uint32_t> readings;    ///< the first reading of each cell

  /// `same(i, i + 1)`: whether the two readings share a cell.
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
  /// What `valueOf` says of the first reading of each.
  template <typename Value>
  Eigen::VectorXd values(const Value& valueOf) const {
    return Eigen::VectorXd::NullaryExpr(count(), [&](Eigen::Index cell) { return valueOf(readingOf(cell)); });
  }
};

}  // namespace alidade
