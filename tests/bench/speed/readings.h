#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/adjustment/arc/fast_arc_fit.h"

namespace alidade::bench {

// The input of all workloads and peers: arcs of R 400 mm over 120°, seen from L 2405 mm, σ 2″ on both
// circles, the same readings on every machine.

inline constexpr std::size_t pointsOfArc = 17;
inline constexpr std::size_t manyArcs = 100'000;      ///< of W3
inline constexpr std::size_t peerArcs = 500;          ///< the slower peers use only these first ones
inline constexpr std::size_t manyPoints = 1'000'000;  ///< of W4

ArcSetup usualSetup();

/// Reduced readings, rad.
struct ArcReadings {
  std::vector<double> a, e;

  /// The readings of `count` points, beginning with the point `first`.
  std::span<const double> horizontal(std::size_t first, std::size_t count) const;
  std::span<const double> vertical(std::size_t first, std::size_t count) const;
};

/// Consecutive arcs, each with a circle of its own near (1, −0.5, 400) mm.
ArcReadings noisyArcs(std::size_t arcs, std::size_t points);

/// The arcs of W3; the first is that of W1, the first two those of W2.
const ArcReadings& shortArcs();
/// The arc of W4.
const ArcReadings& longArc();

}  // namespace alidade::bench
