#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/diagnosis/candidates/cell_functions.h"
#include "core/diagnosis/candidates/cells.h"
#include "core/diagnosis/gap/leftover.h"

namespace alidade {

// Patterns that readings may follow: functions of something that several readings have in common, the place
// of the slider or the moment, times what one unit does to each reading. Readings with the same value of
// the functions are a cell; all sums are taken cell by cell.

/// What one unit does to each reading, and which readings share a cell.
class Carrier {
 public:
  /// `values`: kept in single precision, as no pattern is known better. A cell lies within a visit. What asks
  /// for a leftover again wants the same one.
  Carrier(const Leftover& leftover, const Eigen::VectorXd& values, std::shared_ptr<const Cells> cells);

  Eigen::Index cells() const { return m_cells->count(); }
  /// How many readings it moves.
  Eigen::Index moved() const { return static_cast<Eigen::Index>(m_moved.size()); }
  /// Of each cell: the sum of its squared values.
  const Eigen::VectorXd& squares() const { return m_squares; }
  /// The same less what lies along the arc angles, where every visit has one cell only; else empty.
  Eigen::VectorXd squaresOutsideArcAngles(const Leftover& leftover) const;
  /// Of each cell: the sum of values times a vector over the readings.
  Eigen::VectorXd gathered(const Eigen::VectorXd& overReadings) const;
  /// Values times what is given for each cell, over the readings.
  Eigen::VectorXd spread(const Eigen::VectorXd& overCells) const;
  /// Functions of the cells from `first` on (cells × functions) summed over each visit, as far as they lie
  /// along its arc angle. The cells begin and end with a visit.
  Eigen::MatrixXd alongVisits(const Leftover& leftover, Eigen::Index first,
                              const Eigen::MatrixXd& functions) const;
  /// Inner products of functions of the cells from `first` on with what the fit takes up: unknowns ×
  /// functions.
  Eigen::MatrixXd taken(const Leftover& leftover, Eigen::Index first, const Eigen::MatrixXd& functions) const;
  /// The last cell of the visit that a cell belongs to.
  Eigen::Index lastOfVisit(const Leftover& leftover, Eigen::Index cell) const;
  /// Inner products of the visible parts of one function for each group of cells: 1 in the group, 0
  /// elsewhere. `groups`: of each cell, numbered from 0 to `count`; −1 for none.
  Eigen::MatrixXd visibleGramOfGroups(const Leftover& leftover, const std::vector<Eigen::Index>& groups,
                                      Eigen::Index count) const;
  /// Of each cell: the sum of the values of both. They have the same cells.
  Eigen::VectorXd productsWith(const Carrier& other) const;

 private:
  struct Moved {
    std::uint32_t reading;
    float value;
  };
  std::shared_ptr<const Cells> m_cells;
  std::vector<Moved> m_moved;  ///< in the order of the readings, so of the cells
  Eigen::VectorXd m_squares, m_along;

  Eigen::Index readings() const { return static_cast<Eigen::Index>(m_cells->ofReadings.size()); }
  Eigen::Index visitOf(const Leftover& leftover, Eigen::Index cell) const {
    return static_cast<Eigen::Index>(leftover.reading(m_cells->readingOf(cell)).visit);
  }
  std::uint32_t cellOf(const Moved& moved) const { return m_cells->ofReadings[moved.reading]; }
  void takeOffAlongVisits(const Leftover& leftover, Eigen::MatrixXd& gram,
                          const std::vector<Eigen::Index>& groups) const;
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
  Eigen::MatrixXd visibleGram(const Leftover& leftover) const;

 private:
  /// The functions of some cells, side by side.
  Eigen::MatrixXd piece(Eigen::Index firstCell, Eigen::Index length) const;
};

}  // namespace alidade
