#include "core/evaluation/remedies.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

constexpr std::ptrdiff_t fewestSightings = 5;  // an arc has three unknowns and needs some redundancy

std::string twoDigits(double value) {
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(value))));
  return displayShortest(std::round(value * std::pow(10, decimals)) / std::pow(10, decimals));
}

}  // namespace

std::optional<Jump> jumpOf(const Gap& gap, const Cause& cause) {
  if (cause.effect != jumpId || cause.parameters.empty()) return std::nullopt;
  const auto sequence = static_cast<std::size_t>(cause.parameters.back().value) - 1;
  const Measurement& measurement = *gap.evaluation->examined.measurement;
  const std::vector<ArcMeasurement>& arcs = measurement.arcs;
  for (const ArcMeasurement& arc : arcs) {
    const auto split = std::find_if(arc.sightings.begin(), arc.sightings.end(),
                                    [&](const Sighting& sighting) { return sighting.sequence == sequence; });
    if (split == arc.sightings.end()) continue;
    const std::size_t rows = gap.evaluation->session.positions[arc.position].readings.size();
    Jump jump{.place = {.position = arc.position, .reading = split->row, .field = "horizontal"}};
    jump.isAtZero = split == arc.sightings.begin();
    jump.isLast = &arc == &arcs.back();  // arcs are in the order read
    // A position's own zero was read before the jump. Only a common zero can fit the rows after the jump.
    if (measurement.hasOneZero() && !jump.isLast &&
        std::distance(split, arc.sightings.end()) >= fewestSightings && split->row > 0)
      jump.before = RowRange{arc.position, 0, split->row};
    if (std::distance(arc.sightings.begin(), split) >= fewestSightings)
      jump.after = RowRange{arc.position, split->row, rows - split->row};
    return jump;
  }
  return std::nullopt;
}

std::optional<StatedNoise> scatterOf(const Gap& gap, const Cause& cause) {
  if (cause.effect != noiseId || cause.parameters.empty()) return std::nullopt;
  const Measurement& measurement = *gap.evaluation->examined.measurement;
  const double ratio = cause.parameters.front().value;
  return StatedNoise{twoDigits(ratio * measurement.sigmaHorizontal.arcseconds()),
                     twoDigits(ratio * measurement.sigmaVertical.arcseconds())};
}

}  // namespace alidade
