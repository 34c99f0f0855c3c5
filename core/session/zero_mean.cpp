#include "core/session/zero_mean.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/square.h"

namespace alidade {

namespace {

/// Means of the sightings in one face.
struct FaceMean {
  int count = 0;
  Angle a, e;
};

FaceMean meanOf(const std::vector<SightedZero>& sightings, const auto& takes) {
  FaceMean mean;
  for (const SightedZero& one : sightings) {
    if (!takes(one)) continue;
    ++mean.count;
    mean.a = mean.a + one.a;
    mean.e = mean.e + one.e;
  }
  if (mean.count == 0) return mean;
  return {mean.count, mean.a * (1.0 / mean.count), mean.e * (1.0 / mean.count)};
}

FaceMean meanOfFace(const std::vector<SightedZero>& sightings, int face) {
  return meanOf(sightings, [face](const SightedZero& one) { return one.face == face; });
}

/// The mean change of the zero in the faces sighted both before and after the readings; absent if none was.
std::optional<ZeroSightings::Move> moveOf(const std::vector<SightedZero>& sightings) {
  ZeroSightings::Move move{.horizontal = {}, .vertical = {}, .factor = 0};
  Angle apartHorizontal, apartVertical;
  int faces = 0;
  for (const int face : {1, 2}) {
    const auto at = [&](bool isAfter) {
      return meanOf(sightings,
                    [&](const SightedZero& one) { return one.face == face && one.isAfter == isAfter; });
    };
    const FaceMean before = at(false), after = at(true);
    if (before.count == 0 || after.count == 0) continue;
    ++faces;
    const Angle horizontal = after.a - before.a, vertical = after.e - before.e;
    move.horizontal = move.horizontal + horizontal;
    move.vertical = move.vertical + vertical;
    apartHorizontal = horizontal - apartHorizontal;
    apartVertical = vertical - apartVertical;
    move.factor += 1.0 / before.count + 1.0 / after.count;
  }
  if (faces == 0) return std::nullopt;
  move.horizontal = move.horizontal * (1.0 / faces);
  move.vertical = move.vertical * (1.0 / faces);
  move.factor = std::sqrt(move.factor) / faces;
  if (faces == 2) {
    move.apartHorizontal = apartHorizontal * 0.5;
    move.apartVertical = apartVertical * 0.5;
  }
  return move;
}

}  // namespace

ZeroMean zeroMeanOf(const std::vector<SightedZero>& sightings, bool isInBothFaces) {
  std::vector<SightedZero> counting = sightings;
  std::erase_if(counting, [&](const SightedZero& one) { return one.face == 2 && !isInBothFaces; });
  ZeroMean zero{.a = {},
                .e = {},
                .sightings = {.count = static_cast<int>(counting.size()),
                              .isInBothFaces = isInBothFaces,
                              .factor = 0,
                              .hasLeftOutFace = counting.size() < sightings.size(),
                              .moved = moveOf(counting)}};
  const int faces = isInBothFaces ? 2 : 1;
  for (int face = 1; face <= faces; ++face) {
    const FaceMean mean = meanOfFace(counting, face);
    zero.a = zero.a + mean.a * (1.0 / faces);
    zero.e = zero.e + mean.e * (1.0 / faces);
    zero.sightings.factor += 1.0 / mean.count;
  }
  zero.sightings.factor = std::sqrt(zero.sightings.factor) / faces;
  return zero;
}

void ZeroScatter::add(const std::vector<SightedZero>& sightings) {
  for (const int face : {1, 2}) {
    const FaceMean mean = meanOfFace(sightings, face);
    if (mean.count < 2) continue;
    for (const SightedZero& one : sightings) {
      if (one.face != face) continue;
      if (m_horizontal > Angle()) m_chiSquare += square((one.a - mean.a).radians() / m_horizontal.radians());
      if (m_vertical > Angle()) m_chiSquare += square((one.e - mean.e).radians() / m_vertical.radians());
    }
    m_degreesOfFreedom +=
        (mean.count - 1) * ((m_horizontal > Angle() ? 1 : 0) + (m_vertical > Angle() ? 1 : 0));
  }
}

double ZeroScatter::factor() const {
  return m_degreesOfFreedom > 0 ? std::max(1.0, std::sqrt(m_chiSquare / m_degreesOfFreedom)) : 1;
}

bool isCheckedZero(const Measurement& measurement, std::size_t arc, std::size_t index) {
  const std::vector<SightedZero>& sightings = measurement.arcs[arc].zeroSightings;
  return !measurement.hasOneZero() &&
         std::ranges::count(sightings, sightings[index].face, &SightedZero::face) > 1;
}

Measurement withoutZeroSighting(Measurement measurement, std::size_t arc, std::size_t index) {
  ArcMeasurement& own = measurement.arcs[arc];
  own.zeroSightings.erase(own.zeroSightings.begin() + static_cast<std::ptrdiff_t>(index));
  const ZeroMean mean = zeroMeanOf(own.zeroSightings, own.zero.isInBothFaces);
  const double up = measurement.verticalCircle == VerticalCircle::Zenith ? -1 : 1;
  const bool hadLeftOutFace = std::exchange(own.zero, mean.sightings).hasLeftOutFace;
  own.zero.hasLeftOutFace = hadLeftOutFace;
  if (own.zero.moved)
    for (Angle* const vertical : {&own.zero.moved->vertical, &own.zero.moved->apartVertical})
      *vertical = *vertical * up;
  own.zeroHorizontal = own.zeroHorizontal + mean.a;
  own.zeroVertical = own.zeroVertical + mean.e * up;
  own.zeroElevation = own.zeroElevation + mean.e;
  for (Sighting& sighting : own.sightings) {
    sighting.a = sighting.a - mean.a;
    sighting.e = sighting.e - mean.e;
  }
  for (SightedZero& zero : own.zeroSightings) {
    zero.a = zero.a - mean.a;
    zero.e = zero.e - mean.e;
  }
  ZeroScatter scatter(measurement.sigmaZeroHorizontal, measurement.sigmaZeroVertical);
  for (const ArcMeasurement& each : measurement.arcs) scatter.add(each.zeroSightings);
  measurement.zeroScatter = scatter.factor();
  setMoments(measurement);
  return measurement;
}

}  // namespace alidade
