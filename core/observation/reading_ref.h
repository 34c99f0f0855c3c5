#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/angle.h"
#include "core/session/measurement.h"

namespace alidade {

enum class ReadingKind : std::uint8_t { Horizontal, Vertical, Slider };
inline constexpr std::size_t readingKinds = 3;

/// "horizontal", "vertical" or "slider": as in files and results.
std::string_view nameOf(ReadingKind kind);
/// The name for people.
std::string inWords(ReadingKind kind);

/// Identifies a reading of a measurement.
struct ReadingRef {
  std::size_t arc = 0;       ///< index into the measurement's arcs
  std::size_t sighting = 0;  ///< index into the arc's sightings; for a slider reading, its row
  ReadingKind kind = ReadingKind::Horizontal;

  bool operator==(const ReadingRef&) const = default;
};

/// σ stated for readings of a kind.
Angle statedSigma(const Measurement& measurement, ReadingKind kind);

/// Sign of reduced angles relative to the circle: −1 for zenith circles in face 1 and for elevation circles
/// in face 2, otherwise 1.
double sideOf(const Measurement& measurement, int face, ReadingKind kind);

}  // namespace alidade
