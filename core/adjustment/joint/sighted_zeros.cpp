#include "core/adjustment/joint/sighted_zeros.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alidade {

namespace {

constexpr double likeMarks = 30, likeCircles = 3600;  // arcsec

/// The greatest difference of any zero from the first, arcsec.
struct Differences {
  double horizontal = 0, vertical = 0;
};

Differences differencesOf(const Measurement& measurement) {
  Differences greatest;
  for (const ArcMeasurement& arc : measurement.arcs) {
    const ArcMeasurement& first = measurement.arcs.front();
    const auto apart = [](Angle a, Angle b) { return std::abs(wrapped(a - b).arcseconds()); };
    greatest.horizontal = std::max(greatest.horizontal, apart(arc.zeroHorizontal, first.zeroHorizontal));
    greatest.vertical = std::max(greatest.vertical, apart(arc.zeroElevation, first.zeroElevation));
  }
  return greatest;
}

/// A zero of which only the direction is known counts as sighted once, just before its rows.
std::vector<SightedZero> sightingsOf(const Measurement& measurement, std::size_t index) {
  const ArcMeasurement& arc = measurement.arcs[index];
  const bool isElsewhere =
      measurement.hasOneZero() &&
      std::ranges::any_of(measurement.arcs, [](const ArcMeasurement& a) { return !a.zeroSightings.empty(); });
  if (!arc.zeroSightings.empty() || isElsewhere || (measurement.hasOneZero() && index > 0))
    return arc.zeroSightings;
  SightedZero once;
  if (!arc.sightings.empty()) {
    const Sighting& first = *std::ranges::min_element(arc.sightings, {}, &Sighting::sequence);
    once.order = first.order;
    once.elapsed = first.elapsed;
  }
  return {once};
}

}  // namespace

CommonZeros commonZeros(const Measurement& measurement) {
  if (measurement.hasOneZero()) return {true, true};
  const bool mayBeOneSighting = measurement.zeroIs == ZeroIs::Unstated &&
                                measurement.pointingZeros == PointingZeros::Unstated &&
                                hasAlikeZeros(measurement);
  const bool isMark = measurement.zeroIs == ZeroIs::Mark || measurement.zeroIs == ZeroIs::Unstated;
  if (!isMark || mayBeOneSighting) return {};
  return {differencesOf(measurement).horizontal <= likeCircles, true};
}

bool areZerosInDoubt(const Measurement& measurement) {
  if (measurement.zeroIs != ZeroIs::Unstated || measurement.arcs.empty()) return false;
  const Differences differ = differencesOf(measurement);
  return (differ.horizontal > likeMarks && differ.horizontal <= likeCircles) || differ.vertical > likeMarks;
}

Measurement withZerosSighted(Measurement measurement) {
  measurement.sightedZeros = commonZeros(measurement);
  for (std::size_t i = 0; i < measurement.arcs.size(); ++i) {
    ArcMeasurement& arc = measurement.arcs[i];
    arc.zeroSightings = sightingsOf(measurement, i);
    const ArcMeasurement& first = measurement.arcs.front();
    const Angle a = measurement.sightedZeros->horizontal ? wrapped(arc.zeroHorizontal - first.zeroHorizontal)
                                                         : Angle(),
                e = measurement.sightedZeros->vertical ? arc.zeroElevation - first.zeroElevation : Angle();
    for (Sighting& sighting : arc.sightings) {
      sighting.a = sighting.a + a;
      sighting.e = sighting.e + e;
    }
    for (SightedZero& zero : arc.zeroSightings) {
      zero.a = zero.a + a;
      zero.e = zero.e + e;
    }
    arc.zeroHorizontal = arc.zeroHorizontal - a;
    arc.zeroElevation = arc.zeroElevation - e;
  }
  putInZeros(measurement);
  return measurement;
}

std::size_t indexOfZero(const ArcMeasurement& arc, std::size_t sighting) {
  return sighting - (arc.sightings.size() - arc.zeroSightings.size());
}

void leaveOutZeros(Measurement& measurement) {
  for (ArcMeasurement& arc : measurement.arcs) std::erase_if(arc.sightings, &Sighting::isZero);
}

void putInZeros(Measurement& measurement) {
  constexpr int roundOfZeros = std::numeric_limits<int>::max();  // after all rounds of rows
  leaveOutZeros(measurement);
  for (ArcMeasurement& arc : measurement.arcs) {
    int point = 0;
    for (const SightedZero& zero : arc.zeroSightings) {
      Sighting sighting;
      sighting.row = std::numeric_limits<std::size_t>::max();
      sighting.order = zero.order;
      sighting.elapsed = zero.elapsed;
      sighting.point = --point;
      sighting.round = roundOfZeros;
      sighting.face = zero.face;
      sighting.a = zero.a;
      sighting.e = zero.e;
      sighting.isZero = true;
      arc.sightings.push_back(sighting);
    }
  }
}

Angle sigmaOf(const Measurement& measurement, const Sighting& sighting, bool isVertical) {
  constexpr double least = 1e-9;  // rad: a smaller σ would outweigh all other observations
  if (!sighting.isZero) return isVertical ? measurement.sigmaVertical : measurement.sigmaHorizontal;
  const Angle once = isVertical ? measurement.sigmaZeroVertical : measurement.sigmaZeroHorizontal;
  return Angle::fromRadians(std::max(least, once.radians()));
}

Angle sigmaOf(const Measurement& measurement, const ReadingRef& reading) {
  if (reading.kind == ReadingKind::Slider) return measurement.sigmaSlider;
  return sigmaOf(measurement, measurement.arcs[reading.arc].sightings[reading.sighting],
                 reading.kind == ReadingKind::Vertical);
}

}  // namespace alidade
