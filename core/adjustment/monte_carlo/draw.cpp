#include "core/adjustment/monte_carlo/draw.h"

#include <boost/random/chi_squared_distribution.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <cstdint>

namespace alidade {

namespace {

/// Adapts a random source to Boost's distributions, whose numbers are the same on every machine.
struct Bits {
  using result_type = std::uint64_t;  // NOLINT(readability-identifier-naming)

  RandomSource& source;
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return ~result_type(); }
  result_type operator()() { return source.bits(); }
};

}  // namespace

DrawPlan::DrawPlan(const Measurement& fitted, const NoiseScale& noise)
    : m_noise(noise),
      m_zeroScatter(fitted.zerosAreReadings && noise.factor > fitted.zeroScatter ? fitted.zeroScatter : 0),
      m_terms(estimatedTerms(fitted).size()),
      m_count(firstTerm + m_terms) {
  for (const ArcMeasurement& arc : fitted.arcs) {
    const bool isAnothers = fitted.hasOneZero() && !m_zeros.empty();
    m_zeros.push_back(isAnothers ? m_zeros.front() : m_count);
    if (!isAnothers) m_count += 2;
    std::vector<std::size_t>& readings = m_readings.emplace_back();
    readings.reserve(arc.sightings.size());
    for (const Sighting& sighting : arc.sightings) {
      readings.push_back(m_count);
      m_count += sighting.slider ? 3 : 2;
    }
  }
}

double DrawPlan::drawScale(RandomSource& random) const {
  const double freedom = m_noise.degreesOfFreedom;
  if (!std::isfinite(freedom)) return m_noise.factor;
  Bits bits{random};
  return m_noise.factor / std::sqrt(boost::random::chi_squared_distribution(freedom)(bits) / freedom);
}

void DrawPlan::drawInto(Draw& draw, std::uint64_t seed, std::uint64_t number) const {
  RandomSource random(seed, number);
  draw.scale = drawScale(random);
  draw.zeroScale = m_zeroScatter > 0 ? draw.scale / m_zeroScatter : 1;
  draw.normals.resize(m_count);
  RandomSource rest = random;  // a local copy, so that its state stays in registers
  Bits bits{rest};
  boost::random::normal_distribution normal;
  for (double& value : draw.normals) value = normal(bits);
}

}  // namespace alidade
