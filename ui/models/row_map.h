#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace alidade::ui {

/// Which row of an earlier state of a table a row of the present one was. Edits made since are told to it,
/// and cost by how many there were, not by how many rows there are.
class RowMap {
 public:
  struct Origin {
    std::size_t row = 0;
    bool isUntouched = true;  ///< false: it was edited since
  };

  /// The present state is the earlier one.
  void reset();
  /// From `first` on, `removed` rows gave way to `inserted`. As many as before: they are the same rows,
  /// edited.
  void replace(std::size_t first, std::size_t removed, std::size_t inserted);
  /// Absent: the row is new.
  std::optional<Origin> origin(std::size_t row) const;
  std::size_t pieceCount() const { return m_pieces.size(); }

 private:
  /// Rows from `first` to the next piece; the last has no end.
  struct Piece {
    std::size_t first = 0;
    std::optional<Origin> origin = Origin{};  ///< of the first of them; absent: all are new
  };

  static std::optional<Origin> advanced(std::optional<Origin> origin, std::size_t rows);
  std::size_t splitAt(std::size_t row);
  void join();

  std::vector<Piece> m_pieces = {{}};  ///< ascending, the first from row 0 on
};

}  // namespace alidade::ui
