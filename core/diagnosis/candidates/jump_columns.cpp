#include "core/diagnosis/candidates/jump_columns.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::Matrix2d, Eigen::Matrix2Xd, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

JumpColumns::JumpColumns(const Leftover& leftover, std::vector<JumpMoment> moments, double size)
    : m_horizontal(leftover.column(ErrorTerm::HorizontalJump) * size),
      m_vertical(leftover.column(ErrorTerm::VerticalJump) * size),
      m_moments(std::move(moments)) {
  for (Index i = 0; i < leftover.readings(); ++i) {
    const std::size_t row = leftover.reading(i).sequence;
    const auto after = std::ranges::upper_bound(m_moments, row, {}, &JumpMoment::first);
    const bool touches = after != m_moments.begin() && row < std::prev(after)->end;
    m_last.push_back(touches ? after - m_moments.begin() - 1 : -1);
  }
}

Matrix2Xd JumpColumns::products(const VectorXd& overReadings) const {
  Matrix2Xd sums = Matrix2Xd::Zero(2, static_cast<Index>(m_moments.size()));
  for (Index i = 0; i < m_horizontal.size(); ++i) {
    const Index last = m_last[static_cast<std::size_t>(i)];
    if (last < 0) continue;
    sums(0, last) += m_horizontal[i] * overReadings[i];
    sums(1, last) += m_vertical[i] * overReadings[i];
  }
  for (Index m = sums.cols() - 1; m > 0; --m)
    if (goesOnFrom(static_cast<std::size_t>(m))) sums.col(m - 1) += sums.col(m);
  return sums;
}

/// Gram matrices of the columns after the projection, which removes the arc angle of each visit and the span
/// of the unknowns.
std::vector<Matrix2d> JumpColumns::visibleGrams(const Leftover& leftover) const {
  std::vector<Matrix2d> grams(m_moments.size(), Matrix2d::Zero());
  if (m_moments.empty()) return grams;
  const auto gramAt = [&](Index moment) -> Matrix2d& { return grams[static_cast<std::size_t>(moment)]; };
  std::vector<Index> latestFirst;
  for (Index v = 0; v < leftover.visits(); ++v) {
    const Leftover::Run visit = leftover.readingsOf(v);
    latestFirst.resize(static_cast<std::size_t>(visit.length()));
    std::iota(latestFirst.begin(), latestFirst.end(), visit.first);
    std::ranges::sort(latestFirst, std::greater{},
                      [&](Index i) { return m_last[static_cast<std::size_t>(i)]; });
    Vector2d share = Vector2d::Zero();
    for (const Index i : latestFirst) {
      const Index last = m_last[static_cast<std::size_t>(i)];
      if (last < 0) break;
      const Vector2d both(m_horizontal[i], m_vertical[i]), before = share;
      share += leftover.reading(i).along * both;
      gramAt(last) += both * both.transpose() - share * share.transpose() + before * before.transpose();
    }
  }
  for (std::size_t m = m_moments.size(); m-- > 1;)
    if (goesOnFrom(m)) grams[m - 1] += grams[m];
  MatrixXd ofHorizontal = MatrixXd::Zero(leftover.basis().cols(), static_cast<Index>(m_moments.size())),
           ofVertical = ofHorizontal;
  for (Index i = 0; i < m_horizontal.size(); ++i) {
    const Index last = m_last[static_cast<std::size_t>(i)];
    if (last < 0) continue;
    ofHorizontal.col(last) += m_horizontal[i] * leftover.basisOfRow(i);
    ofVertical.col(last) += m_vertical[i] * leftover.basisOfRow(i);
  }
  for (Index m = ofHorizontal.cols(); m-- > 0;) {
    const auto h = ofHorizontal.col(m), v = ofVertical.col(m);
    const double both = h.dot(v);
    gramAt(m) -= Matrix2d{{h.squaredNorm(), both}, {both, v.squaredNorm()}};
    if (m == 0 || !goesOnFrom(static_cast<std::size_t>(m))) continue;
    ofHorizontal.col(m - 1) += h;
    ofVertical.col(m - 1) += v;
  }
  return grams;
}

}  // namespace alidade
