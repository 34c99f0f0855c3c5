#pragma once

#include <string_view>
#include <vector>

#include "core/diagnosis/candidates/candidates.h"

namespace alidade {

// Effects that would move Δd and leave no trace in these readings.

/// What moves Δd by less is not worth a word, mm.
inline constexpr double negligibleInfluence = 1e-3;

/// An effect of its plausible size, of a known one as large as what is known leaves open, in the direction of
/// its numbers that moves Δd most; of the two signs the one that shows less.
struct Detectability {
  std::string_view effect;  ///< its id; static text
  Eigen::VectorXd weights;  ///< in plausible sizes; zero where it does not move Δd
  double influence = 0;     ///< on Δd to first order, mm, ≥ 0
  double visible = 0;       ///< what it leaves in the readings, bent where it bends, σ

  /// More than `negligibleInfluence`, and less than `clearlyDifferent` σ.
  bool isUndetectable() const;
};

/// `perReading`: ∂Δd/∂reading, mm per σ of the reading.
Detectability detectabilityOf(const Component& component, const SharedProducts& perReading);

/// Those that are undetectable, the most dangerous first; of a jump the worst moment.
std::vector<Detectability> undetectableEffects(const Leftover& leftover, const Candidates& candidates,
                                               const Eigen::VectorXd& perReading);

/// Of each position the jumps that are undetectable, together: those between its zero and its first sighting,
/// and those during its readings. Each is there with the prior odds of its moment (`PriorOdds`), and its size
/// has each of the plausible widths.
std::vector<UndetectableJump> undetectableJumps(const Leftover& leftover, const Candidates& candidates,
                                                const Eigen::VectorXd& perReading,
                                                const Measurement& measurement);

}  // namespace alidade
