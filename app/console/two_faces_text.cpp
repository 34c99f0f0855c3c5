#include "app/console/two_faces_text.h"

#include <vector>

#include "app/console/text_layout.h"
#include "core/base/number_text.h"
#include "core/wording/position_name.h"

namespace alidade::console {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string seconds(Angle angle) {
  return fixedText(angle.arcseconds(), 1);
}

std::vector<std::string> errorRow(const std::string& name, const InstrumentError& error) {
  return {"  " + name, fixedText(error.value.arcseconds(), 2), fixedText(error.sigma.arcseconds(), 2)};
}

std::string scatterText(const std::string& what, const FaceScatter& scatter) {
  if (scatter.degreesOfFreedom <= 0) return "";
  return what + " scatters " + fixedText(scatter.ratio(), 2) + " times as much as stated (" +
         std::to_string(scatter.degreesOfFreedom) + " degrees of freedom).\n";
}

}  // namespace

std::string twoFacesText(const Measurement& measurement, const TwoFaces& faces) {
  Rows table = {
      {"Both faces", "round", "point", "elevation (°)", "2c (″)", "off its course (″)", "index (″)"}};
  for (const FaceDifference& visit : faces.visits) {
    const ArcMeasurement& arc = measurement.arcs[visit.arc];
    const Sighting& sighting = arc.sightings[visit.faceOne];
    table.push_back({"  axis " + positionName(arc.axisDeg, arc.time), std::to_string(sighting.round),
                     std::to_string(sighting.point), fixedText(visit.elevation.degrees(), 3),
                     seconds(visit.doubleCollimation), seconds(visit.fromCourse), seconds(visit.index)});
  }
  Rows errors = {{"From both faces", "value (″)", "u (″)"}, errorRow("collimation c", faces.collimation)};
  if (faces.trunnionTilt) errors.push_back(errorRow("trunnion tilt i", *faces.trunnionTilt));
  errors.push_back(errorRow("vertical index j", faces.index));
  return "\n" + alignedColumns(table) + "\n" + alignedColumns(errors) + scatterText("2c", faces.horizontal) +
         scatterText("The index", faces.vertical);
}

}  // namespace alidade::console
