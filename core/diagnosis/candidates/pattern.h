#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/diagnosis/candidates/cell_functions.h"
#include "core/diagnosis/candidates/cells.h"
#include "core/diagnosis/gap/leftover.h"

namespace alidade {

// Patterns that readings may follow. A pattern is a function of an argument, such as the visit or the time,
// times a carrier. The carrier is the change of each reading, in σ, by a function value of 1. Readings with
// the same function values form a cell; all sums run over cells.

/// The change of each reading, in σ, by a function value of 1, and the cells of the readings.
class Carrier {
 public:
  /// `values` are stored in single precision: no pattern is known more precisely. Each cell lies within one
  /// visit. Methods with a parameter `leftover` need the leftover of the constructor.
  Carrier(const Leftover& leftover, const Eigen::VectorXd& values, std::shared_ptr<const Cells> cells);

  Eigen::Index cells() const { return m_cells->count(); }
  /// Number of readings that a function value of 1 changes.
  Eigen::Index moved() const { return static_cast<Eigen::Index>(m_moved.size()); }
  /// Sum of the squared values of each cell.
  const Eigen::VectorXd& squares() const { return m_squares; }
  /// `squares()` without the part that the arc angles absorb. Empty unless every visit is one cell.
  Eigen::VectorXd squaresOutsideArcAngles(const Leftover& leftover) const;
  /// Sum over each cell of the values times a vector over the readings.
  Eigen::VectorXd gathered(const Eigen::VectorXd& overReadings) const;
  /// Product of the values and one number for each cell, over the readings.
  Eigen::VectorXd spread(const Eigen::VectorXd& overCells) const;
  /// Inner products of functions with the derivative by the arc angle of each visit: visits × functions.
  /// `functions` (cells × functions) belong to the cells from `first` on, which make up whole visits.
  Eigen::MatrixXd alongVisits(const Leftover& leftover, Eigen::Index first,
                              const Eigen::MatrixXd& functions) const;
  /// Inner products of functions of the cells from `first` on with the basis of the unknowns: unknowns ×
  /// functions.
  Eigen::MatrixXd taken(const Leftover& leftover, Eigen::Index first, const Eigen::MatrixXd& functions) const;
  /// The last cell of the visit that contains `cell`.
  Eigen::Index lastOfVisit(const Leftover& leftover, Eigen::Index cell) const;
  /// Gram matrix of the visible parts of one function per group: 1 in the cells of the group, 0 elsewhere.
  /// `groups` gives the group of each cell, from 0 to `count` − 1; −1 means none.
  Eigen::MatrixXd visibleGramOfGroups(const Leftover& leftover, const std::vector<Eigen::Index>& groups,
                                      Eigen::Index count) const;
  /// Sum over each cell of the products of both carriers' values. Both have the same cells.
  Eigen::VectorXd productsWith(const Carrier& other) const;

 private:
  struct Moved {
    std::uint32_t reading;
    float value;
  };
  std::shared_ptr<const Cells> m_cells;
  std::vector<Moved> m_moved;  ///< in the order of the readings, which is the order of the cells
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
  /// Product of the columns and the weights, over the readings.
  Eigen::VectorXd times(const Eigen::VectorXd& weights) const;
  /// Scales the columns so that weights of variance 1 change the affected readings by 1σ (root mean square).
  /// Returns the factor; 0 if no reading is affected.
  double normalise();
  /// Gram matrix of the visible parts of the columns.
  Eigen::MatrixXd visibleGram(const Leftover& leftover) const;

 private:
  /// The functions of all parts, side by side, in `length` cells from `firstCell` on.
  Eigen::MatrixXd piece(Eigen::Index firstCell, Eigen::Index length) const;
};

}  // namespace alidade
