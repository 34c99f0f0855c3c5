#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/diagnosis/cell_functions.h"
#include "core/diagnosis/leftover.h"

namespace alidade {

// Patterns that readings may follow, for the .cpp files of this room only: functions of something that
// several readings have in common, the place of the slider or the moment, times what one unit does to each
// reading. Readings with the same value of the functions are a cell; all sums are taken cell by cell.

/// What one unit does to each reading, and which readings share a cell.
class Carrier {
 public:
  /// `leftover`: asked again for inner products of visible parts; it has to live until the last of them.
  /// `cells`: of each reading, numbered from 0 in the order of the readings; a cell lies within a visit.
  Carrier(const Leftover& leftover, const Eigen::VectorXd& values, const std::vector<Eigen::Index>& cells);

  Eigen::Index cells() const { return m_squares.size(); }
  Eigen::Index visits() const { return m_visitCount; }
  Eigen::Index unknowns() const { return m_leftover->basis().cols(); }
  /// How many readings it moves.
  Eigen::Index moved() const { return static_cast<Eigen::Index>(m_moved.size()); }
  /// Of each cell: the sum of its squared values.
  const Eigen::VectorXd& squares() const { return m_squares; }
  /// The same less what lies along the arc angles, where every visit has one cell only; else empty.
  const Eigen::VectorXd& squaresOutsideArcAngles() const { return m_squaresOutside; }
  /// Of each cell: the sum of values times a vector over the readings.
  Eigen::VectorXd gathered(const Eigen::VectorXd& overReadings) const;
  /// Values times what is given for each cell, over the readings.
  Eigen::VectorXd spread(const Eigen::VectorXd& overCells) const;
  /// Functions (cells × functions) summed over each visit, as far as they lie along its arc angle.
  Eigen::MatrixXd alongVisits(const Eigen::MatrixXd& functions) const;
  /// Inner products of functions with what the fit takes up: unknowns × functions.
  Eigen::MatrixXd taken(const Eigen::MatrixXd& functions) const;
  /// Inner products of the visible parts of one function for each group of cells: 1 in the group, 0
  /// elsewhere. `groups`: of each cell, numbered from 0 to `count`; −1 for none.
  Eigen::MatrixXd visibleGramOfGroups(const std::vector<Eigen::Index>& groups, Eigen::Index count) const;
  /// Of each cell: the sum of the values of both. They have the same cells.
  Eigen::VectorXd productsWith(const Carrier& other) const;

 private:
  /// A reading that is moved, its cell, and by how much.
  struct Moved {
    std::uint32_t reading, cell;  // there are no more rows than `limits::mostRows`
    double value;
  };
  const Leftover* m_leftover;
  Eigen::Index m_readings, m_visitCount;
  std::vector<Moved> m_moved;           ///< in the order of the readings, so of the cells
  std::vector<std::uint32_t> m_visits;  ///< of each cell
  Eigen::VectorXd m_squares, m_squaresOutside, m_along;

  Eigen::Index visitOf(Eigen::Index cell) const { return m_visits[static_cast<std::size_t>(cell)]; }
  void takeOffAlongVisits(Eigen::MatrixXd& gram, const std::vector<Eigen::Index>& groups) const;
};

/// Columns over the readings: the functions of every part, side by side.
struct Pattern {
  struct Part {
    std::shared_ptr<const Carrier> carrier;
    CellFunctions functions;
  };
  std::vector<Part> parts;

  Eigen::Index columns() const;
  /// Columns times weights, over the readings.
  Eigen::VectorXd times(const Eigen::VectorXd& weights) const;
  /// Scales the columns so that a weight of 1 moves the readings it moves by 1σ in the mean; by how much. 0
  /// where it moves none.
  double normalise();
  /// The inner products of the visible parts of the columns with one another.
  Eigen::MatrixXd visibleGram() const;
};

}  // namespace alidade
