#include "core/diagnosis/gap/gap_size.h"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.h"

namespace alidade {

double rmsOf(const GapModel& model) {
  double squares = 0;
  int count = 0;
  for (const AdjustedReading& reading : model.fit->readings) {
    const bool out =
        std::ranges::find(model.options.without, ReadingRef{reading.arc, reading.sighting, reading.kind}) !=
        model.options.without.end();
    if (out || reading.kind == ReadingKind::Slider) continue;
    squares += std::pow(Angle::fromRadians(reading.residual).arcseconds(), 2);
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

GapSize sizeOf(const GapModel& model) {
  const double rms = rmsOf(model), f = model.fit->degreesOfFreedom, chiSquare = model.fit->chiSquare;
  const std::optional<double> tail = chiSquareUpperTail(chiSquare, f);
  return tail ? GapSize{rms, chiSquare / f, *tail} : GapSize{.rms = rms};
}

double excessOf(const GapModel& model) {
  return std::max(0.0, model.fit->chiSquare - model.fit->degreesOfFreedom);
}

std::optional<IntersectionEstimate> estimateOf(const GapModel& model) {
  const std::optional<Intersection> found = intersect(*model.measurement, *model.fit);
  if (!found) return std::nullopt;
  return estimateOf(*found);
}

}  // namespace alidade
