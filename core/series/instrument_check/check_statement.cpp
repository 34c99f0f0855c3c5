#include "core/series/instrument_check/check_statement.h"

#include <cmath>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/quantity_text.h"
#include "core/base/visible_text.h"
#include "core/series/instrument_check/check_findings.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;
using Cells = std::vector<std::string>;

constexpr std::size_t longestName = 40;

std::string scatterText(const CheckScatter& scatter) {
  if (!(scatter.dof > 0)) return "—";
  return displayText(scatter.s(), 2) + "″ (" + displayText(scatter.dof, 0) + ")";
}

std::string meanText(const PairMean& mean) {
  return withU(mean.value, mean.u, "″");
}

std::string otherText(const std::optional<TwoCauses>& causes, const std::string& unit) {
  return causes ? withU(causes->other, causes->uOther, unit) : "—";
}

std::string secondsText(double value) {
  return std::isfinite(value) ? displayText(value, 2) + "″" : "—";
}

Cells cellsOf(const StationCheck& station) {
  return {shortened(station.station, longestName),
          std::to_string(station.rounds) + " × " + std::to_string(station.targets),
          scatterText(station.direction),
          scatterText(station.vertical),
          meanText(station.collimation),
          meanText(station.index),
          otherText(station.causes.tilt, "″"),
          otherText(station.causes.lineOfSight, " mm")};
}

Cells pooledCells(const InstrumentCheck& check) {
  return {Phrase::of("all, pooled"),
          "",
          scatterText(check.direction),
          scatterText(check.vertical),
          meanText(check.collimation),
          meanText(check.index),
          check.tilt ? meanText(*check.tilt) : "—",
          otherText(check.lineOfSight, " mm")};
}

Statement byRound(const StationCheck& station) {
  Statement statement{.id = "rounds",
                      .title = Phrase::of("%1, by round", shortened(station.station, longestName)),
                      .columns = {{"round", Phrase::of("Round"), Role::Name},
                                  {"collimation", Phrase::of("Collimation")},
                                  {"index", Phrase::of("Index")},
                                  {"orientation", Phrase::of("Orientation")}},
                      .rows = {}};
  for (const RoundCourse& round : station.course)
    statement.rows.push_back({{shortened(round.name, longestName), secondsText(round.collimation),
                               secondsText(round.index), secondsText(round.orientation)}});
  return statement;
}

Statement byTarget(const StationCheck& station) {
  Statement statement{.id = "targets",
                      .title = Phrase::of("%1, by target", shortened(station.station, longestName)),
                      .columns = {{"target", Phrase::of("Target"), Role::Name},
                                  {"elevation", Phrase::of("Elevation")},
                                  {"distance", Phrase::of("Distance")},
                                  {"collimation", Phrase::of("Collimation")},
                                  {"index", Phrase::of("Index")}},
                      .rows = {}};
  for (const TargetMean& target : station.perTarget)
    statement.rows.push_back({{shortened(target.name, longestName), displayText(target.elevationDeg, 2) + "°",
                               target.distanceM > 0 ? displayText(target.distanceM, 3) + " m" : "—",
                               secondsText(target.collimation), secondsText(target.index)}});
  return statement;
}

}  // namespace

Statement stationsTable(const InstrumentCheck& check) {
  const std::string ofDirection =
                        Phrase::of("Of a direction observed once in both faces, with its degrees of freedom"),
                    ofZenith = Phrase::of(
                        "Of a zenith angle observed once in both faces, with its degrees of freedom");
  Statement statement{
      .id = "instrument_check",
      .title = Phrase::of("Field check after ISO 17123-3"),
      .columns = {{"station", Phrase::of("Station"), Role::Name,
                   Phrase::of("Evaluated one by one; the last row holds all of them")},
                  {"rounds", Phrase::of("Rounds"), Role::Figure, Phrase::of("Complete rounds × targets")},
                  {"s_direction", Phrase::of("s direction (ν)"), Role::Figure, ofDirection},
                  {"s_zenith", Phrase::of("s zenith (ν)"), Role::Figure, ofZenith},
                  {"collimation", Phrase::of("Collimation"), Role::Figure,
                   Phrase::of("c as of face 1, ± its standard uncertainty")},
                  {"index", Phrase::of("Index"), Role::Figure,
                   Phrase::of("Of the vertical circle as of face 1, ± its standard uncertainty")},
                  {"tilt", Phrase::of("Trunnion tilt"), Role::Figure,
                   Phrase::of(
                       "i, estimated together with the collimation, from targets at several elevations")},
                  {"line_of_sight", Phrase::of("Line of sight"), Role::Figure,
                   Phrase::of("e, by which it passes the axis, from targets at several distances")}},
      .rows = {},
      .note = Phrase::of(
          "Rounds × targets; s: of a direction or a zenith angle observed once in both faces, ν: degrees of "
          "freedom. Collimation and index as of face 1; line of sight: its distance from the axis; each ± "
          "its "
          "standard uncertainty.")};
  for (const StationCheck& station : check.stations) statement.rows.push_back({cellsOf(station)});
  if (check.stations.size() > 1) statement.rows.push_back({.cells = pooledCells(check), .isTotal = true});
  return statement;
}

std::vector<Statement> stationDetails(const StationCheck& station) {
  constexpr std::size_t mostRows = 40;
  if (station.course.empty() || station.course.size() > mostRows || station.targets > mostRows) return {};
  return {byRound(station), byTarget(station)};
}

}  // namespace alidade
