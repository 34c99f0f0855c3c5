#pragma once

#include <string_view>
#include <vector>

#include "core/diagnosis/candidates/candidates.h"

namespace alidade {

// Effects that change Δd without a visible trace in these readings.

/// The detectability of an effect of plausible size, or of its known uncertainty. Its parameters have the
/// direction that changes Δd most, and the sign with the smaller trace.
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

/// Returns the undetectable effects, the largest influence first; a jump has the moment of largest influence.
std::vector<Detectability> undetectableEffects(const Leftover& leftover, const Candidates& candidates,
                                               const Eigen::VectorXd& perReading);

/// Returns the undetectable jumps. A position has up to two entries: jumps between zero and first sighting,
/// and jumps during the readings. An entry has their total prior odds (`PriorOdds`) and all prior widths.
std::vector<UndetectableJump> undetectableJumps(const Leftover& leftover, const Candidates& candidates,
                                                const Eigen::VectorXd& perReading,
                                                const Measurement& measurement);

}  // namespace alidade
