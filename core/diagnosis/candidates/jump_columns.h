#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/diagnosis/gap/leftover.h"

namespace alidade {

// Jumps of the orientation before any of many rows. A jump touches all readings from its row on, so its
// inner products are sums from the end of the session: all moments together cost hardly more than one, and
// no columns are kept.
class JumpColumns {
 public:
  /// `moments`: sequences of the first rows after a jump, ascending. `size`: of both its parts, rad.
  JumpColumns(const Leftover& leftover, std::vector<std::size_t> moments, double size);

  /// Of the horizontal and the vertical column of every moment with a vector over the readings: 2 × moments.
  Eigen::Matrix2Xd products(const Eigen::VectorXd& overReadings) const;
  /// Of the visible parts of the two columns of every moment with one another. `leftover`: the same.
  std::vector<Eigen::Matrix2d> visibleGrams(const Leftover& leftover) const;
  const std::vector<std::size_t>& moments() const { return m_moments; }

 private:
  Eigen::VectorXd m_horizontal, m_vertical;  ///< of a jump before every row
  std::vector<Eigen::Index> m_last;  ///< of each reading: the last moment that comes before it, −1 for none
  std::vector<std::size_t> m_moments;
};

}  // namespace alidade
