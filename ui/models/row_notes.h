#pragma once

#include <QString>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "ui/document/reading_column.h"
#include "ui/jobs/fit_job.h"

namespace alidade::ui {

/// Notes of the newest evaluation on the rows of one position. Later edits are tracked, so that untouched
/// rows keep their notes; a retyped row keeps only its residual.
class RowNotes {
 public:
  explicit RowNotes(std::size_t position) : m_position(position) {}

  /// What a view must show again after an evaluation.
  enum class News { None, Residuals, Everything };
  News setEvaluation(SharedEvaluation evaluation);
  /// Reports that `inserted` rows replaced `removed` rows from `first` on.
  void replaceRows(std::size_t first, std::size_t removed, std::size_t inserted);

  /// Null if the row was not in the fit.
  const SightingResidual* residual(std::size_t row) const;
  /// The reason why the entry is unusable; empty without a known problem.
  QString problem(std::size_t row, ReadingColumn column) const;
  /// The reason why the reading looks misread.
  QString suspicion(std::size_t row, ReadingColumn column) const;

 private:
  /// Row and index of a problem or suspect, in the order of the rows.
  using Index = std::vector<std::pair<std::size_t, std::size_t>>;

  void restart();
  template <typename Item>
  Index indexOf(const std::vector<Item>& items) const;
  template <typename Item>
  const Item* find(const std::vector<Item>& items, const Index& index, std::size_t row,
                   ReadingColumn column) const;
  const ArcFit* arc() const { return m_evaluation ? m_evaluation->fit.arcOfPosition(m_position) : nullptr; }

  struct Origin {
    std::size_t row = 0;
    bool isUntouched = true;  ///< false: the row was edited after the evaluation
  };
  std::optional<Origin> origin(std::size_t row) const {
    return row < m_origins.size() ? m_origins[row] : std::nullopt;
  }

  std::size_t m_position;
  SharedEvaluation m_evaluation;  ///< null before the first evaluation
  Index m_problems, m_suspects;
  std::vector<std::optional<Origin>> m_origins;  ///< origin of each row in the evaluated session; absent: new
  bool m_isMoved = false;                        ///< whether any row has changed since the evaluation
};

}  // namespace alidade::ui
