#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace alidade::ui {

/// Maps rows of the present table to rows of an earlier state. Receives the edits since then; the cost
/// depends on the number of edits, not of rows.
class RowMap {
 public:
  struct Origin {
    std::size_t row = 0;
    bool isUntouched = true;  ///< false: edited since
  };

  /// Makes the present state the earlier one.
  void reset();
  /// `inserted` rows replaced `removed` rows from `first` on. Equal numbers: the same rows, edited.
  void replace(std::size_t first, std::size_t removed, std::size_t inserted);
  /// Absent for a new row.
  std::optional<Origin> origin(std::size_t row) const;
  std::size_t pieceCount() const { return m_pieces.size(); }

 private:
  /// Rows from `first` to the next piece; the last has no end.
  struct Piece {
    std::size_t first = 0;
    std::optional<Origin> origin = Origin{};  ///< of its first row; absent: all are new
  };

  static std::optional<Origin> advanced(std::optional<Origin> origin, std::size_t rows);
  std::size_t splitAt(std::size_t row);
  void join();

  std::vector<Piece> m_pieces = {{}};  ///< ascending, the first from row 0 on
};

}  // namespace alidade::ui
