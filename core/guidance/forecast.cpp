#include "core/guidance/forecast.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/session/face.h"

namespace alidade {

namespace {

constexpr Angle zeroTolerance = Angle::fromArcseconds(900);

/// Places of a protocol without coordinates are spread from 10° to 170°, as by `plan`.
double evenPlace(std::size_t index, std::size_t count) {
  constexpr double first = 10, last = 170;
  const auto gaps = static_cast<double>(std::max<std::size_t>(count, 2) - 1);
  return Angle::fromDegrees(first + (last - first) * static_cast<double>(index) / gaps).radians();
}

std::size_t positionCount(const Measurement& measurement, const ProtocolProgress& progress) {
  std::size_t count = 0;
  for (const ArcMeasurement& arc : measurement.arcs) count = std::max(count, arc.position + 1);
  for (const FollowedSighting& followed : progress.sightings)
    if (followed.position) count = std::max(count, *followed.position + 1);
  return count;
}

/// The expected reading of a zero in a face, from α0 and β0 in face 1.
ExpectedReading zeroReading(const ArcMeasurement& arc, const PlannedSighting& planned,
                            VerticalCircle circle) {
  const FaceOneReading circles = inFaceOne(arc.zeroHorizontal, arc.zeroVertical, planned.face, circle);
  return {{arc.position, 0, 1, planned.face},
          wrapped(circles.horizontal, Angle::fromDegrees(180)),
          wrapped(circles.vertical, Angle::fromDegrees(circle == VerticalCircle::Zenith ? 180 : 90)),
          zeroTolerance};
}

}  // namespace

NominalPlaces nominalPlaces(const SightingProtocol& protocol, const std::vector<std::size_t>& positions) {
  NominalPlaces nominal;
  for (std::size_t p = 0; p < protocol.positions.size(); ++p) {
    const std::vector<ProtocolPlace>& places = protocol.placesOf(protocol.positions[p]);
    const bool isStated = std::ranges::any_of(
        places, [](const ProtocolPlace& place) { return nominalPlace(place).has_value(); });
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto place = nominalPlace(places[i]);
      if (isStated && !place) continue;
      nominal[{positions[p], places[i].point}] = place ? place->radians() : evenPlace(i, places.size());
    }
  }
  return nominal;
}

std::optional<ProtocolArcs> arcsOf(const Measurement& measurement, const SightingProtocol& protocol,
                                   const ProtocolProgress& progress) {
  ProtocolArcs arcs{measurement, {}};
  std::map<std::size_t, std::size_t> ofSession;
  for (const FollowedSighting& followed : progress.sightings)
    if (followed.position) ofSession[followed.planned.protocolPosition] = *followed.position;
  const auto arcOf = [&](std::size_t protocolPosition) -> const ArcMeasurement* {
    const auto position = ofSession.find(protocolPosition);
    if (position == ofSession.end()) return nullptr;
    const auto arc = std::ranges::find(measurement.arcs, position->second, &ArcMeasurement::position);
    return arc == measurement.arcs.end() ? nullptr : &*arc;
  };
  std::size_t known = 0;
  while (known < protocol.positions.size() && !arcOf(known)) ++known;
  if (known == protocol.positions.size()) return std::nullopt;
  const ArcMeasurement like = *arcOf(known);
  std::size_t further = positionCount(measurement, progress);
  std::map<int, int> repeats;
  for (std::size_t p = 0; p < protocol.positions.size(); ++p) {
    const int axisDeg = protocol.positions[p].axisDeg, repeat = ++repeats[axisDeg];
    if (const ArcMeasurement* own = arcOf(p)) {
      arcs.positions.push_back(own->position);
      continue;
    }
    const auto there = ofSession.find(p);
    arcs.positions.push_back(there == ofSession.end() ? further++ : there->second);
    ArcMeasurement arc;
    arc.position = arcs.positions.back();
    arc.axisDeg = axisDeg;
    arc.repeat = repeat;
    arc.zeroHorizontal = wrapped(
        like.zeroHorizontal + circleTurn(protocol.positions[p]) - circleTurn(protocol.positions[known]),
        Angle::fromDegrees(180));
    arc.zeroVertical = like.zeroVertical;
    arc.zeroElevation = like.zeroElevation;
    arcs.measurement.arcs.push_back(std::move(arc));
  }
  return arcs;
}

std::vector<std::optional<ExpectedReading>> forecast(const Measurement& measurement, const SessionFit& fit,
                                                     const SightingProtocol& protocol,
                                                     const ProtocolProgress& progress) {
  std::vector<std::optional<ExpectedReading>> expected(progress.sightings.size());
  const auto arcs = arcsOf(measurement, protocol, progress);
  if (!arcs) return expected;
  std::vector<SightingToCome> places;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < progress.sightings.size(); ++i) {
    const PlannedSighting& planned = progress.sightings[i].planned;
    const std::size_t position = arcs->positions[planned.protocolPosition];
    if (planned.isZero) {
      const auto arc = std::ranges::find(arcs->measurement.arcs, position, &ArcMeasurement::position);
      expected[i] = zeroReading(*arc, planned, measurement.verticalCircle);
      continue;
    }
    places.push_back({position, planned.point, planned.round, planned.face});
    indices.push_back(i);
  }
  const auto read =
      expectedReadings(arcs->measurement, fit, places, nominalPlaces(protocol, arcs->positions));
  for (std::size_t i = 0; i < indices.size(); ++i) expected[indices[i]] = read[i];
  return expected;
}

}  // namespace alidade
