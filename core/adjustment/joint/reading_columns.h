#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/observation/reading_ref.h"

namespace alidade {

/// Columns over readings, stored separately for each kind: an unknown that moves one circle often does not
/// move the other and the slider, whose column is then empty.
class ReadingColumns {
 public:
  ReadingColumns() = default;
  explicit ReadingColumns(std::size_t columns) {
    for (OfKind& own : m_kinds) own.columns.resize(columns);
  }

  /// Reserves memory for this many readings of the kind.
  void reserve(ReadingKind kind, std::size_t readings) { ofKind(kind).readings = readings; }
  /// Readings of a kind are numbered from 0 and appended in order, each with every column.
  void append(ReadingKind kind, std::size_t number, std::size_t column, double value) {
    OfKind& own = ofKind(kind);
    std::vector<double>& values = own.columns[column];
    if (values.empty()) {
      if (value == 0) return;
      values.reserve(own.readings);
      values.resize(number);
    }
    values.push_back(value);
  }
  /// Scales every column of one reading.
  void scale(ReadingKind kind, std::size_t number, double factor) {
    for (std::vector<double>& values : ofKind(kind).columns)
      if (!values.empty()) values[number] *= factor;
  }
  double at(ReadingKind kind, std::size_t number, std::size_t column) const {
    const std::span<const double> values = of(kind, column);
    return values.empty() ? 0 : values[number];
  }
  /// The column over all readings of the kind; empty if all its values are 0.
  std::span<const double> of(ReadingKind kind, std::size_t column) const {
    return m_kinds[static_cast<std::size_t>(kind)].columns[column];
  }

 private:
  struct OfKind {
    std::size_t readings = 0;
    std::vector<std::vector<double>> columns;
  };
  std::array<OfKind, readingKinds> m_kinds;

  OfKind& ofKind(ReadingKind kind) { return m_kinds[static_cast<std::size_t>(kind)]; }
};

}  // namespace alidade
