#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/adjustment/arc/foot_point.h"
#include "core/base/eight.h"

namespace alidade {

// All visits of an arc at their foot points (foot_point.h), eight at a time, and their normal equations. Both
// faces of a visit read the same, so each kind of reading has one row, weighted by its number of readings.
// Subtracting the component along the arc eliminates the arc angle. The residuals come from series. If one of
// eight visits has a residual above 0.001 rad, the eight are processed one by one.

/// Normal equations over the estimated quantities, (Δx, Δy, R) in mm and the slider's zero in rad, and the
/// considered ones: the pointing zeros of a and e in rad, and L in mm. From the stated σ.
struct ArcEquations {
  static constexpr std::size_t estimated = 4, considered = 3, columns = estimated + considered;

  std::array<std::array<double, columns>, estimated> normal{};  ///< JᵀWJ, a row for each estimated quantity
  std::array<double, estimated> rightSide{};                    ///< −½ ∂χ²/∂estimated
  double chiSquare = 0;                                         ///< of the means of the visits
};

/// Reliability of one reading of each kind at a visit: horizontal, vertical, slider.
struct VisitReliability {
  std::array<double, 3> redundancy{};  ///< 0…1
  std::array<double, 3> rate{};        ///< ∂(requested quantity)/∂(reading in σ)
};

class VisitFeet {
 public:
  explicit VisitFeet(const ArcView& view) : m_view(view) {}

  void reserve(std::size_t visits) { m_blocks.reserve((visits + eight - 1) / eight); }
  void add(const VisitReading& visit);
  std::size_t size() const { return m_size; }
  const ArcView& view() const { return m_view; }
  VisitReading reading(std::size_t visit) const;

  enum class From { Plane, Before };
  /// Moves every visit to its foot: from the nearest point in the plane, or from the last foot. Needs R > 0.
  ArcEquations converge(const ArcUnknowns& unknowns, From from);

  // Results of a converged visit, in radians.
  double arcAngle(std::size_t visit) const;         ///< in (−π, π]
  Direction<double> left(std::size_t visit) const;  ///< mean of the readings minus that of a perfect
                                                    ///< instrument
  double sliderLeft(std::size_t visit) const;       ///< the same for the slider, if it was read

  /// Reliability of the eight converged visits from `eight` · `block` on. `cofactor`: inverse of the normal
  /// matrix of the estimated quantities; `requested`: `cofactor` times the gradient of the requested
  /// quantity.
  using Cofactor = std::array<std::array<double, ArcEquations::estimated>, ArcEquations::estimated>;
  std::array<VisitReliability, eight> reliabilityOf(
      std::size_t block, const Cofactor& cofactor,
      const std::array<double, ArcEquations::estimated>& requested) const;

  /// Eight visits; in the last block the last visit fills empty lanes and counts once.
  struct alignas(sizeof(Eight)) Block {
    Foot<Eight> foot;
    Eight tanA, tanE, rows, counts;          ///< counts: rows, 0 for empty lanes
    Eight slider, sliderRows, sliderCounts;  ///< rows: 1 if the slider was read; counts: the same, 0 for
                                             ///< empty lanes
  };

 private:
  void convergeSeparately(Block& block, const ArcUnknowns& unknowns, From from) const;
  void lookAtSliders(Block& block, const ArcUnknowns& unknowns) const;

  ArcView m_view;
  std::vector<Block> m_blocks;
  std::size_t m_size = 0;
  bool m_hasSlider = false;
  ArcUnknowns m_unknowns;  ///< of the last `converge`
};

}  // namespace alidade
