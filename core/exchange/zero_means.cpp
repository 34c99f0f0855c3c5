#include "core/exchange/zero_means.h"

#include <optional>

#include "core/base/angle_text.h"
#include "core/session/face.h"

namespace alidade {

namespace {

/// Decimals of arcseconds in a mean of several sightings: finer than any circle's last digit.
constexpr int meanDecimals = 2;

/// The mean in face 1; absent if one of the angles cannot be read.
std::optional<FaceOneReading> meanOf(const std::vector<const RecordedSighting*>& sightings,
                                     VerticalCircle circle) {
  std::vector<FaceOneReading> readings;
  for (const RecordedSighting* sighting : sightings) {
    const Result<Angle> horizontal = parseAngle(sighting->row.horizontal);
    const Result<Angle> vertical = parseAngle(sighting->row.vertical);
    if (!horizontal || !vertical) return std::nullopt;
    readings.push_back(inFaceOne(*horizontal, *vertical, sighting->row.face == "2" ? 2 : 1, circle));
  }
  const FaceOneReading first = readings.front();
  FaceOneReading sum{};
  for (const FaceOneReading& reading : readings) {
    sum.horizontal = sum.horizontal + wrapped(reading.horizontal, first.horizontal);
    sum.vertical = sum.vertical + wrapped(reading.vertical, first.vertical);
  }
  const double share = 1 / static_cast<double>(readings.size());
  return FaceOneReading{sum.horizontal * share, sum.vertical * share};
}

std::string written(Angle angle, Angle centre) {
  return formatDms(wrappedAsWritten(angle, meanDecimals, centre), meanDecimals, AngleSigns::Typewriter);
}

}  // namespace

ZeroMean zeroMean(const std::vector<const RecordedSighting*>& sightings, VerticalCircle circle) {
  const Reading& first = sightings.front()->row;
  const auto mean = sightings.size() > 1 || first.face == "2" ? meanOf(sightings, circle) : std::nullopt;
  if (!mean) return {.horizontal = first.horizontal, .vertical = first.vertical, .isMean = false};
  const Angle half = Angle::fromDegrees(180), quarter = Angle::fromDegrees(90);
  return {.horizontal = written(mean->horizontal, half),
          .vertical = written(mean->vertical, circle == VerticalCircle::Zenith ? half : quarter),
          .isMean = true};
}

}  // namespace alidade
