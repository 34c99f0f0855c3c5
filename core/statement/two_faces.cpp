#include "core/statement/two_faces.h"

#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;

Statement::Row rowOf(std::string name, const InstrumentError* error, const FaceScatter& scatter) {
  std::string value = "—";
  if (error) {
    const double u = error->sigma.arcseconds();
    const int decimals = decimalsFor(u, 1);
    value = displayText(error->value.arcseconds(), decimals) + " (" + displayText(u, decimals) + ")";
  }
  return {{std::move(name), std::move(value),
           scatter.degreesOfFreedom > 0 ? "× " + displayText(scatter.ratio(), 2) : "—"}};
}

}  // namespace

Statement instrumentErrors(const TwoFaces& faces) {
  return {.id = "two_faces",
          .title = Phrase::of("From both faces"),
          .columns = {{"error", "", Role::Name},
                      {"value", Phrase::of("value (u), ″"), Role::Figure,
                       Phrase::of("With standard uncertainty; signs of face 1. A trunnion tilt needs three "
                                  "visits at different elevations")},
                      {"scatter", Phrase::of("scatter against the stated σ"), Role::Figure,
                       Phrase::of("About × 1 where the differences of the faces scatter as stated")}},
          .rows = {rowOf(Phrase::of("collimation c"), &faces.collimation, faces.horizontal),
                   rowOf(Phrase::of("trunnion tilt i"), faces.trunnionTilt ? &*faces.trunnionTilt : nullptr,
                         faces.horizontal),
                   rowOf(Phrase::of("vertical index j"), &faces.index, faces.vertical)},
          .note = Phrase::of("Signs of face 1. Visits read in both faces: %1.", faces.visits.size())};
}

Statement faceDifferences(const Measurement& measurement, const TwoFaces& faces) {
  Statement statement{.id = "face_differences",
                      .title = Phrase::of("Both faces"),
                      .columns = {{"axis", Phrase::of("Axis"), Role::Name},
                                  {"round", Phrase::of("Round")},
                                  {"point", Phrase::of("Point")},
                                  {"elevation", Phrase::of("Elevation °")},
                                  {"double_collimation", "2c ″"},
                                  {"from_course", Phrase::of("2c residual ″")},
                                  {"index", Phrase::of("Index ″")}},
                      .rows = {}};
  const auto seconds = [](Angle angle) { return displayText(angle.arcseconds(), 1); };
  for (const FaceDifference& visit : faces.visits) {
    const ArcMeasurement& arc = measurement.arcs[visit.arc];
    const Sighting& sighting = arc.sightings[visit.faceOne];
    statement.rows.push_back(
        {{positionName(arc.axisDeg, arc.repeat), std::to_string(sighting.round),
          std::to_string(sighting.point), displayText(visit.elevation.degrees(), 3),
          seconds(visit.doubleCollimation), seconds(visit.fromCourse), seconds(visit.index)}});
  }
  return statement;
}

}  // namespace alidade
