#include "ui/models/row_notes.h"

#include <algorithm>
#include <iterator>

#include "core/wording/suspects.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

bool isBefore(const std::pair<std::size_t, std::size_t>& item, std::size_t row) {
  return item.first < row;
}

bool saysSame(const Problem& a, const Problem& b) {
  return a.where == b.where && a.what == b.what;
}

bool saysSame(const Suspect& a, const Suspect& b) {
  return a.where == b.where && sentenceOf(a) == sentenceOf(b);
}

template <typename Item, typename Index>
bool areSame(const std::vector<Item>& a, const Index& inA, const std::vector<Item>& b, const Index& inB) {
  return std::equal(inA.begin(), inA.end(), inB.begin(), inB.end(), [&](const auto& one, const auto& other) {
    return saysSame(a[one.second], b[other.second]);
  });
}

bool areSame(const ArcFit* a, const ArcFit* b) {
  if (!a || !b) return a == b;
  return std::equal(a->residuals.begin(), a->residuals.end(), b->residuals.begin(), b->residuals.end(),
                    [](const SightingResidual& one, const SightingResidual& other) {
                      return one.row == other.row && one.horizontal == other.horizontal &&
                             one.vertical == other.vertical;
                    });
}

}  // namespace

template <typename Item>
RowNotes::Index RowNotes::indexOf(const std::vector<Item>& items) const {
  Index index;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].where.position == m_position && items[i].where.reading)
      index.emplace_back(*items[i].where.reading, i);
  if (!std::is_sorted(index.begin(), index.end())) std::sort(index.begin(), index.end());
  return index;
}

RowNotes::News RowNotes::setEvaluation(SharedEvaluation evaluation) {
  const bool isMoved = std::exchange(m_isMoved, false);
  const SharedEvaluation before = std::exchange(m_evaluation, std::move(evaluation));
  Index problems = indexOf(m_evaluation->examined.problems), suspects = indexOf(m_evaluation->suspects);
  problems.swap(m_problems);
  suspects.swap(m_suspects);
  restart();
  const Evaluation none{};
  const Evaluation& old = before ? *before : none;
  const bool saysNew =
      isMoved ? !(problems.empty() && suspects.empty() && m_problems.empty() && m_suspects.empty())
              : !areSame(old.examined.problems, problems, m_evaluation->examined.problems, m_problems) ||
                    !areSame(old.suspects, suspects, m_evaluation->suspects, m_suspects);
  if (saysNew) return News::Everything;
  const bool fitsNew = isMoved || !areSame(old.fit.arcOfPosition(m_position), arc());
  return fitsNew ? News::Residuals : News::None;
}

void RowNotes::replaceRows(std::size_t first, std::size_t removed, std::size_t inserted) {
  if (removed == 0 && inserted == 0) return;
  m_isMoved = true;
  const std::size_t from = std::min(first, m_origins.size()),
                    to = std::min(first + removed, m_origins.size());
  const auto at = [this](std::size_t row) {
    return std::next(m_origins.begin(), static_cast<std::ptrdiff_t>(row));
  };
  if (removed == inserted) {
    for (auto origin = at(from); origin != at(to); ++origin)
      if (*origin) (*origin)->isUntouched = false;
  } else {
    m_origins.insert(m_origins.erase(at(from), at(to)), inserted, std::nullopt);
  }
}

/// Sets the origin of every row to the row with the same index in the evaluated session.
void RowNotes::restart() {
  const auto& positions = m_evaluation->session.positions;
  m_origins.resize(m_position < positions.size() ? positions[m_position].readings.size() : 0);
  for (std::size_t row = 0; row < m_origins.size(); ++row) m_origins[row] = Origin{row};
}

const SightingResidual* RowNotes::residual(std::size_t row) const {
  const ArcFit* fitted = arc();
  const std::optional<Origin> from = origin(row);
  if (!fitted || !from) return nullptr;
  const auto& residuals = fitted->residuals;
  const auto found = std::lower_bound(
      residuals.begin(), residuals.end(), from->row,
      [](const SightingResidual& residual, std::size_t number) { return residual.row < number; });
  return found != residuals.end() && found->row == from->row ? &*found : nullptr;
}

template <typename Item>
const Item* RowNotes::find(const std::vector<Item>& items, const Index& index, std::size_t row,
                           ReadingColumn column) const {
  const std::optional<Origin> from = origin(row);
  if (!from || !from->isUntouched) return nullptr;
  auto found = std::lower_bound(index.begin(), index.end(), from->row, isBefore);
  for (; found != index.end() && found->first == from->row; ++found)
    if (readingColumn(items[found->second].where.field) == column) return &items[found->second];
  return nullptr;
}

QString RowNotes::problem(std::size_t row, ReadingColumn column) const {
  const Problem* problem =
      m_problems.empty() ? nullptr : find(m_evaluation->examined.problems, m_problems, row, column);
  return problem ? qText(problem->what) : QString();
}

QString RowNotes::suspicion(std::size_t row, ReadingColumn column) const {
  const Suspect* suspect =
      m_suspects.empty() ? nullptr : find(m_evaluation->suspects, m_suspects, row, column);
  return suspect ? qText(sentenceOf(*suspect)) : QString();
}

}  // namespace alidade::ui
