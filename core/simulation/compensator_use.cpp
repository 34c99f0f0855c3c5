#include "core/simulation/compensator_use.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/number_text.h"
#include "core/base/random_source.h"
#include "core/session/compensator.h"
#include "core/session/measurement.h"

namespace alidade {

namespace {

/// A random stream independent of the session's noise, which is drawn from `seed` itself.
RandomSource randomOf(std::uint64_t seed) {
  return RandomSource(seed ^ 0x636F6D70ULL);
}

double sizeOf(const Truth& truth, ErrorTerm term) {
  const auto found = std::ranges::find(truth.effects, term, &TrueSize::term);
  return found == truth.effects.end() ? 0 : found->value;
}

/// Written to 0.1″.
std::string written(double arcseconds) {
  return shortestText(std::round(arcseconds * 10) / 10);
}

}  // namespace

Truth leftByCompensator(Truth truth, Angle sigma, std::uint64_t seed) {
  RandomSource random = randomOf(seed);
  for (const ErrorTerm term : {ErrorTerm::VerticalAxisTiltX, ErrorTerm::VerticalAxisTiltZ}) {
    std::erase_if(truth.effects, [term](const TrueSize& size) { return size.term == term; });
    truth.effects.push_back({term, sigma.arcseconds() * random.normal()});
  }
  return truth;
}

void stateCompensator(Session& session, const Truth& truth, CompensatorUse use, Angle sigma,
                      std::uint64_t seed) {
  session.instrument.sigmaCompensatorArcsec = shortestText(std::round(sigma.arcseconds() * 1e6) / 1e6);
  for (Position& position : session.positions)
    for (Reading& row : position.readings)
      row.corrections = use == CompensatorUse::On ? "inclination standing_axis" : "none";
  if (use != CompensatorUse::Measured) return;
  const AxisTilt tilt{sizeOf(truth, ErrorTerm::VerticalAxisTiltX),
                      sizeOf(truth, ErrorTerm::VerticalAxisTiltZ)};
  RandomSource random = randomOf(seed);
  const auto error = [&] { return sigma.arcseconds() * random.normal(); };
  const double indexCross = error(), indexLength = error();
  const Examined examined = examine(session);
  if (!examined.measurement) return;
  for (const ArcMeasurement& arc : examined.measurement->arcs)
    for (const Sighting& sighting : arc.sightings) {
      Reading& row = session.positions[arc.position].readings[sighting.row];
      const TiltsRead read = tiltsRead(tilt, sighting.a, sighting.face);
      row.tiltCrossArcsec = written(read.cross + indexCross + error());
      row.tiltLengthArcsec = written(read.length + indexLength + error());
    }
}

}  // namespace alidade
