#include "core/adjustment/suspects.h"

#include <algorithm>
#include <cmath>

#include "core/adjustment/misreadings.h"
#include "core/base/angle_text.h"
#include "core/base/quantity_text.h"

namespace alidade {

namespace {

const char* fieldOf(ReadingKind kind) {
  if (kind == ReadingKind::Horizontal) return "horizontal";
  return kind == ReadingKind::Vertical ? "vertical" : "slider";
}

/// The measurement with only those arcs that were fitted.
Measurement fittedPart(const Measurement& measurement, const SessionFit& fit) {
  Measurement part = measurement;
  std::erase_if(part.arcs, [&](const ArcMeasurement& arc) { return !fit.arcOfPosition(arc.position); });
  return part;
}

Place placeOf(const Measurement& measurement, const ReadingRef& cell) {
  const ArcMeasurement& arc = measurement.arcs[cell.arc];
  return {.position = arc.position, .reading = arc.sightings[cell.sighting].row, .field = fieldOf(cell.kind)};
}

/// Reduced angles count face 2 and zenith circles the other way round than their circles.
double sideOf(const Measurement& measurement, const Sighting& sighting, ReadingKind kind) {
  if (kind != ReadingKind::Vertical) return 1;
  const double down = measurement.verticalCircle == VerticalCircle::Zenith ? -1 : 1;
  return sighting.face == 1 ? down : -down;
}

/// In arcseconds up to two minutes, then as an angle, with its sign.
std::string signedSize(Angle size) {
  const double seconds = size.arcseconds();
  const std::string sign = seconds < 0 ? "" : "+";
  if (std::abs(seconds) < 120) return sign + displayText(seconds, 1) + "″";
  return sign + formatDms(size);
}

std::string nameOf(const Suspect& suspect) {
  std::string name = std::to_string(suspect.axisDeg) + "°, point " + std::to_string(suspect.point);
  if (suspect.round != 1) name += ", round " + std::to_string(suspect.round);
  if (suspect.face != 1) name += ", face " + std::to_string(suspect.face);
  return name + ", " + fieldOf(suspect.kind);
}

Suspect suspectOf(const Measurement& measurement, const MisreadReading& misreading) {
  const ArcMeasurement& arc = measurement.arcs[misreading.cell.arc];
  const Sighting& sighting = arc.sightings[misreading.cell.sighting];
  const ReadingKind kind = misreading.cell.kind;
  Suspect suspect;
  suspect.where = placeOf(measurement, misreading.cell);
  suspect.axisDeg = arc.axisDeg;
  suspect.point = sighting.point;
  suspect.round = sighting.round;
  suspect.face = sighting.face;
  suspect.kind = kind;
  suspect.size = misreading.size * sideOf(measurement, sighting, kind);
  suspect.studentised = misreading.studentised;
  for (const ReadingRef& rival : misreading.rivals) suspect.rivals.push_back(placeOf(measurement, rival));
  suspect.sentence = nameOf(suspect) + " is off by " + signedSize(suspect.size) + ".";
  return suspect;
}

}  // namespace

std::vector<Suspect> findSuspects(const Session&, const Measurement& measurement, const SessionFit& fit,
                                  const SuspectOptions& options) {
  if (fit.arcs.empty()) return {};
  const Measurement fitted = fittedPart(measurement, fit);
  const MisreadingSearch search =
      searchMisreadings(fitted, {.risk = options.risk, .fit = {.terms = estimatedTerms(fitted)}});
  std::vector<Suspect> suspects;
  for (const MisreadReading& misreading : search.misread) suspects.push_back(suspectOf(fitted, misreading));
  return suspects;
}

std::optional<Finding> suspectsFinding(const std::vector<Suspect>& suspects) {
  if (suspects.empty()) return std::nullopt;
  std::string names;
  for (const Suspect& suspect : suspects) names += (names.empty() ? "" : "; ") + nameOf(suspect);
  const bool one = suspects.size() == 1;
  return Finding{
      Severity::Warning,
      (one ? "A reading looks misread: " : std::to_string(suspects.size()) + " readings look misread: ") +
          names + ".",
      std::string("Check ") + (one ? "it" : "them") + " in the field book, then correct or exclude " +
          (one ? "it" : "them") + "; until then every reading takes part in the result.",
      one ? suspects.front().where : Place{}};
}

}  // namespace alidade
