#include "ui/models/row_map.h"

#include <algorithm>
#include <iterator>

namespace alidade::ui {

void RowMap::reset() {
  m_pieces = {{}};
}

void RowMap::replace(std::size_t first, std::size_t removed, std::size_t inserted) {
  if (removed == 0 && inserted == 0) return;
  const std::size_t from = splitAt(first), to = splitAt(first + removed);
  const auto at = [this](std::size_t piece) {
    return std::next(m_pieces.begin(), static_cast<std::ptrdiff_t>(piece));
  };
  if (removed == inserted) {
    for (auto piece = at(from); piece != at(to); ++piece)
      if (piece->origin) piece->origin->isUntouched = false;
  } else {
    for (auto piece = at(to); piece != m_pieces.end(); ++piece) piece->first += inserted - removed;
    const auto next = m_pieces.erase(at(from), at(to));
    if (inserted > 0) m_pieces.insert(next, Piece{first, std::nullopt});
  }
  join();
}

std::optional<RowMap::Origin> RowMap::origin(std::size_t row) const {
  const auto next = std::upper_bound(m_pieces.begin(), m_pieces.end(), row,
                                     [](std::size_t r, const Piece& piece) { return r < piece.first; });
  const Piece& piece = *std::prev(next);
  return advanced(piece.origin, row - piece.first);
}

std::optional<RowMap::Origin> RowMap::advanced(std::optional<Origin> origin, std::size_t rows) {
  if (origin) origin->row += rows;
  return origin;
}

/// The index of the piece that begins at `row`; splits one if needed.
std::size_t RowMap::splitAt(std::size_t row) {
  const auto next = std::lower_bound(m_pieces.begin(), m_pieces.end(), row,
                                     [](const Piece& piece, std::size_t r) { return piece.first < r; });
  const auto index = static_cast<std::size_t>(std::distance(m_pieces.begin(), next));
  if (next != m_pieces.end() && next->first == row) return index;
  const Piece& before = m_pieces[index - 1];
  const Piece piece{row, advanced(before.origin, row - before.first)};
  m_pieces.insert(next, piece);
  return index;
}

/// Merges pieces that continue the one before them.
void RowMap::join() {
  const auto goesOn = [](const Piece& one, const Piece& next) {
    const auto expected = advanced(one.origin, next.first - one.first);
    if (!expected || !next.origin) return expected.has_value() == next.origin.has_value();
    return expected->row == next.origin->row && expected->isUntouched == next.origin->isUntouched;
  };
  const auto last = std::unique(m_pieces.begin(), m_pieces.end(), goesOn);
  m_pieces.erase(last, m_pieces.end());
}

}  // namespace alidade::ui
