#include "core/adjustment/monte_carlo/draw.h"

#include <cmath>

#include "core/base/ziggurat.h"

namespace alidade {

namespace {

/// χ² with `freedom` ≥ 1 degrees of freedom: twice a Gamma variable (Marsaglia and Tsang, "A simple method
/// for generating gamma variables", 2000). A shape below 1 is raised above it.
double drawChiSquare(RandomSource& random, double freedom) {
  const bool raised = freedom < 2;
  const double d = freedom / 2 + (raised ? 1 : 0) - 1.0 / 3, c = 1 / std::sqrt(9 * d);
  while (true) {
    const double x = zigguratNormal(random), root = 1 + c * x, v = root * root * root;
    const double u = random.uniform();
    if (v > 0 && std::log(u) < x * x / 2 + d - d * v + d * std::log(v))
      return 2 * d * v * (raised ? std::pow(random.uniform(), 2 / freedom) : 1);
  }
}

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
  return m_noise.factor / std::sqrt(drawChiSquare(random, freedom) / freedom);
}

void DrawPlan::drawInto(Draw& draw, std::uint64_t seed, std::uint64_t number) const {
  RandomSource random(seed, number);
  draw.scale = drawScale(random);
  draw.zeroScale = m_zeroScatter > 0 ? draw.scale / m_zeroScatter : 1;
  draw.normals.resize(m_count);
  fillWithNormals(random, draw.normals);
}

}  // namespace alidade
