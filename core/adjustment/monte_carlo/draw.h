#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/base/random_source.h"
#include "core/session/measurement.h"

namespace alidade {

/// One draw of all uncertain quantities of a session, in units of their σ, in the order of `DrawPlan`.
struct Draw {
  double scale = 1;      ///< factor of the noise of readings: s0 times its Student factor
  double zeroScale = 1;  ///< factor of the noise of the pointing zeros
  std::vector<double> normals;
};

/// The order of numbers in a draw: distance, known radius, the priors of error terms; then for each arc both
/// zeros if they are its own, and for each sighting both circles and, if read, the slider.
class DrawPlan {
 public:
  /// `noise`: `SessionFit::noise` of the fit of `fitted`.
  DrawPlan(const Measurement& fitted, const NoiseScale& noise);

  /// Makes draw `number` of the seed, the same for every caller.
  void drawInto(Draw& draw, std::uint64_t seed, std::uint64_t number) const;

  std::size_t terms() const { return m_terms; }
  static constexpr std::size_t distance = 0, radius = 1, firstTerm = 2;
  /// Index in `Draw::normals` of the two zeros of an arc: horizontal, vertical.
  std::size_t zeros(std::size_t arc) const { return m_zeros[arc]; }
  /// Index there of the readings of a sighting: horizontal, vertical, slider.
  std::size_t readings(std::size_t arc, std::size_t sighting) const { return m_readings[arc][sighting]; }

 private:
  double drawScale(RandomSource& random) const;

  NoiseScale m_noise;
  double m_zeroScatter = 0;  ///< factor in the σ of zeros that scatter like the readings; 0 if they do not
  std::size_t m_terms = 0, m_count = 0;
  std::vector<std::size_t> m_zeros;
  std::vector<std::vector<std::size_t>> m_readings;
};

}  // namespace alidade
