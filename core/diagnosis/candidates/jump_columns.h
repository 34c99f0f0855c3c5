#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/diagnosis/candidates/jump_moment.h"
#include "core/diagnosis/gap/leftover.h"

namespace alidade {

// Jumps of the orientation at many moments. A jump acts on all readings from its row to the end of the
// session, or to the next sighting of a zero. Its inner products are therefore partial sums: those of all
// moments take little more time than those of one moment.
class JumpColumns {
 public:
  /// `moments` and their ends are ascending. `size` is the size of both components of a jump, rad.
  JumpColumns(const Leftover& leftover, std::vector<JumpMoment> moments, double size);

  /// Returns the inner products of the horizontal and vertical column of each moment with a vector over the
  /// readings: 2 × moments.
  Eigen::Matrix2Xd products(const Eigen::VectorXd& overReadings) const;
  /// Returns the Gram matrix of the two visible columns of each moment. `leftover` must be the argument of
  /// the constructor.
  std::vector<Eigen::Matrix2d> visibleGrams(const Leftover& leftover) const;
  const std::vector<JumpMoment>& moments() const { return m_moments; }

 private:
  Eigen::VectorXd m_horizontal, m_vertical;  ///< columns of a jump that acts on all rows
  std::vector<Eigen::Index> m_last;          ///< index of the last moment that acts on a reading; −1: none
  std::vector<JumpMoment> m_moments;

  /// Whether the previous moment acts on all readings on which this moment acts.
  bool goesOnFrom(std::size_t moment) const { return m_moments[moment - 1].end == m_moments[moment].end; }
};

}  // namespace alidade
