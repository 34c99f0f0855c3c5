#include "app/console/instrument_text.h"

#include <cmath>

#include "app/console/findings_text.h"
#include "app/console/text_layout.h"
#include "core/base/quantity_text.h"
#include "core/base/visible_text.h"
#include "core/series/instrument_check/check_findings.h"

namespace alidade::console {

namespace {

constexpr std::size_t longestName = 40;

std::string scatterText(const CheckScatter& scatter) {
  return scatter.dof > 0 ? displayText(scatter.s(), 2) + "″" : "—";
}

std::string otherCause(const std::optional<TwoCauses>& causes, const std::string& unit) {
  return causes ? withU(causes->other, causes->uOther, unit) : "—";
}

std::vector<std::string> rowOf(const StationCheck& station) {
  return {shortened(station.station, longestName),
          std::to_string(station.targets),
          std::to_string(station.rounds),
          scatterText(station.direction),
          displayText(station.direction.dof, 0),
          scatterText(station.vertical),
          displayText(station.vertical.dof, 0),
          withU(station.collimation.value, station.collimation.u, "″"),
          withU(station.index.value, station.index.u, "″"),
          otherCause(station.causes.tilt, "″"),
          otherCause(station.causes.lineOfSight, " mm")};
}

std::string stationsTable(const InstrumentCheck& check) {
  std::vector<std::vector<std::string>> rows{
      {"station", "targets", "rounds", "s(Hz)", "ν", "s(V)", "ν", "c", "index", "tilt", "e"}};
  for (const StationCheck& station : check.stations) rows.push_back(rowOf(station));
  if (check.stations.size() > 1)
    rows.push_back({"pooled", "", "", scatterText(check.direction), displayText(check.direction.dof, 0),
                    scatterText(check.vertical), displayText(check.vertical.dof, 0),
                    withU(check.collimation.value, check.collimation.u, "″"),
                    withU(check.index.value, check.index.u, "″"),
                    check.tilt ? withU(check.tilt->value, check.tilt->u, "″") : "—",
                    otherCause(check.lineOfSight, " mm")});
  return alignedColumns(rows);
}

std::string courseTable(const StationCheck& station) {
  std::vector<std::vector<std::string>> rows{{"  round", "c", "index", "orientation"}};
  const auto seconds = [](double value) { return std::isfinite(value) ? displayText(value, 2) + "″" : "—"; };
  for (const RoundCourse& round : station.course)
    rows.push_back({"  " + shortened(round.name, longestName), seconds(round.collimation),
                    seconds(round.index), seconds(round.orientation)});
  return alignedColumns(rows);
}

std::string targetsTable(const StationCheck& station) {
  std::vector<std::vector<std::string>> rows{{"  target", "elevation", "distance", "c", "index"}};
  for (const TargetMean& target : station.perTarget)
    rows.push_back({"  " + shortened(target.name, longestName), displayText(target.elevationDeg, 2) + "°",
                    target.distanceM > 0 ? displayText(target.distanceM, 3) + " m" : "—",
                    displayText(target.collimation, 2) + "″", displayText(target.index, 2) + "″"});
  return alignedColumns(rows);
}

}  // namespace

std::string instrumentText(const std::string& name, const InstrumentCheck& check,
                           const std::vector<Finding>& findings) {
  std::string text = heading(name);
  text +=
      "Field check after ISO 17123-3. s(Hz) and s(V): a direction and a zenith angle observed once in both "
      "faces;\n"
      "ν: degrees of freedom. c and index as of face 1, tilt of the trunnion axis, e: line of sight off the "
      "axis;\n"
      "each ± its standard uncertainty.\n\n";
  text += stationsTable(check);
  constexpr std::size_t mostRounds = 40;
  for (const StationCheck& station : check.stations) {
    if (station.course.empty() || station.course.size() > mostRounds || station.targets > mostRounds)
      continue;
    text += "\n" + shortened(station.station, longestName) + ", by round and by target\n" +
            courseTable(station) + "\n" + targetsTable(station);
  }
  return text + findingsText(findings);
}

}  // namespace alidade::console
