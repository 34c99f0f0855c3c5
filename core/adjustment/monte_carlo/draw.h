#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/base/random_source.h"
#include "core/session/measurement.h"

namespace alidade {

/// One draw of all that is uncertain about a session, in units of its σ. The numbers stand in the order of
/// `DrawPlan`.
struct Draw {
  double scale = 1;      ///< of the noise of readings: s0, and Student's share in it
  double zeroScale = 1;  ///< of the noise of the pointing zeros
  std::vector<double> normals;
};

/// Which numbers a draw is made of: distance, known radius, the priors of error terms; then arc by arc both
/// zeros where they are its own, and sighting by sighting both circles and, where there is one, the slider.
class DrawPlan {
 public:
  /// `fit` is what `fitSession` made of the measurement.
  DrawPlan(const Measurement& fitted, const NoiseScale& noise);

  /// Draw `number` of the seed, whoever asks for it.
  void drawInto(Draw& draw, std::uint64_t seed, std::uint64_t number) const;

  std::size_t terms() const { return m_terms; }
  static constexpr std::size_t distance = 0, radius = 1, firstTerm = 2;
  /// Where the two zeros of an arc stand.
  std::size_t zeros(std::size_t arc) const { return m_zeros[arc]; }
  /// Where the readings of a sighting stand: horizontal, vertical, slider.
  std::size_t readings(std::size_t arc, std::size_t sighting) const { return m_readings[arc][sighting]; }

 private:
  double drawScale(RandomSource& random) const;

  NoiseScale m_noise;
  double m_zeroScatter = 0;  ///< in the σ of zeros that scatter as the readings do; 0: they do not
  std::size_t m_terms = 0, m_count = 0;
  std::vector<std::size_t> m_zeros;
  std::vector<std::vector<std::size_t>> m_readings;
};

}  // namespace alidade
