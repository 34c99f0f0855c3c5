#pragma once

#include <string_view>
#include <vector>

#include "core/diagnosis/candidates/candidates.h"

namespace alidade {

// Effects that change Δd without a visible trace in these readings.

/// The detectability of an effect of plausible size, or of its known uncertainty. Its numbers have the
/// direction that changes Δd most, with the less visible of both signs.
struct Detectability {
  std::string_view effect;  ///< identifier; static text
  Eigen::VectorXd weights;  ///< in plausible sizes; zero if the effect does not change Δd
  double influence = 0;     ///< change of Δd to first order, mm, ≥ 0
  double visible = 0;       ///< length of its trace in the readings, second order included if bent, σ

  /// Whether the influence exceeds `negligibleInfluence` and the trace is below `clearlyDifferent` σ.
  bool isUndetectable() const;
};

/// `perReading` is ∂Δd/∂reading, mm per σ of the reading.
Detectability detectabilityOf(const Component& component, const SharedProducts& perReading);

/// Returns the undetectable effects, the largest influence first; of a jump the worst moment.
std::vector<Detectability> undetectableEffects(const Leftover& leftover, const Candidates& candidates,
                                               const Eigen::VectorXd& perReading);

/// Returns the undetectable jumps, for each position those between zero and first sighting and those during
/// its readings. Each has the prior odds of its moment (`PriorOdds`) and all plausible widths of its size.
std::vector<UndetectableJump> undetectableJumps(const Leftover& leftover, const Candidates& candidates,
                                                const Eigen::VectorXd& perReading,
                                                const Measurement& measurement);

}  // namespace alidade
