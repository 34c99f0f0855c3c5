#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/diagnosis/candidates/jump_moment.h"
#include "core/diagnosis/gap/leftover.h"

namespace alidade {

// Jumps of the orientation before any of many rows. A jump touches all readings from its row on, up to the
// end of the session or to a zero sighted anew, so its inner products are sums from there: all moments
// together cost hardly more than one, and no columns are kept.
class JumpColumns {
 public:
  /// `moments`: ascending, their ends too. `size`: of both parts of a jump, rad.
  JumpColumns(const Leftover& leftover, std::vector<JumpMoment> moments, double size);

  /// Of the horizontal and the vertical column of every moment with a vector over the readings: 2 × moments.
  Eigen::Matrix2Xd products(const Eigen::VectorXd& overReadings) const;
  /// Of the visible parts of the two columns of every moment with one another. `leftover`: the same.
  std::vector<Eigen::Matrix2d> visibleGrams(const Leftover& leftover) const;
  const std::vector<JumpMoment>& moments() const { return m_moments; }

 private:
  Eigen::VectorXd m_horizontal, m_vertical;  ///< of a jump before every row
  std::vector<Eigen::Index> m_last;  ///< of each reading: the last moment that touches it, −1 for none
  std::vector<JumpMoment> m_moments;

  /// What the moment touches, those before it touch, too, up to this one.
  bool goesOnFrom(std::size_t moment) const { return m_moments[moment - 1].end == m_moments[moment].end; }
};

}  // namespace alidade
