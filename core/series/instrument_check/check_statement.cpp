#include "core/series/instrument_check/check_statement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/series/instrument_check/check_findings.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;
using Cells = std::vector<std::string>;

constexpr std::size_t longestName = 40;

std::string scatterText(const CheckScatter& scatter) {
  if (!(scatter.degreesOfFreedom > 0)) return "—";
  return displayText(scatter.s(), 2) + "″ (" + displayText(scatter.degreesOfFreedom, 0) + ")";
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

/// "s of a direction 0.74″ (limit 1.23″)".
std::string judgedText(const CheckScatter& scatter, const std::optional<SigmaTest>& test, bool isDirection) {
  const std::string s = displayText(scatter.s(), 2) + "″";
  if (!test)
    return isDirection ? Phrase::of("s of a direction %1", s) : Phrase::of("s of a zenith angle %1", s);
  const std::string limit = displayText(test->limit, 2) + "″";
  return isDirection ? Phrase::of("s of a direction %1 (limit %2)", s, limit)
                     : Phrase::of("s of a zenith angle %1 (limit %2)", s, limit);
}

std::string statedText(const InstrumentCheck& check) {
  const auto sigma = [](const std::optional<SigmaTest>& test) {
    return test ? displayShortest(test->sigma) + "″" : Phrase::of("not stated");
  };
  return Phrase::of(
      "Stated σ: %1 of a direction, %2 of a zenith angle, both of a value observed once in both faces. χ² "
      "test "
      "of ISO 17123-3, 95 %.",
      sigma(check.directionTest), sigma(check.verticalTest));
}

}  // namespace

std::optional<bool> hasPassed(const InstrumentCheck& check) {
  bool isWhole = false;
  for (const auto& [scatter, test] :
       {std::pair(&check.direction, &check.directionTest), std::pair(&check.vertical, &check.verticalTest)}) {
    if (*test && !(*test)->isWithin()) return false;
    if (!(scatter->degreesOfFreedom > 0)) continue;
    if (!*test) return std::nullopt;
    isWhole = true;
  }
  return isWhole ? std::optional(true) : std::nullopt;
}

Statement checkVerdict(const InstrumentCheck& check, const std::vector<Finding>& findings) {
  std::string figures;
  for (const bool isDirection : {true, false}) {
    const CheckScatter& scatter = isDirection ? check.direction : check.vertical;
    if (!(scatter.degreesOfFreedom > 0)) continue;
    const std::string one =
        judgedText(scatter, isDirection ? check.directionTest : check.verticalTest, isDirection);
    figures = figures.empty() ? one : Phrase::of("%1, %2", figures, one);
  }
  const std::optional<bool> passed = hasPassed(check);
  Statement statement{.id = "check_verdict",
                      .title = !passed   ? Phrase::of("Not judged: %1", figures)
                               : *passed ? Phrase::of("Passed: %1", figures)
                                         : Phrase::of("Failed: %1", figures),
                      .columns = {},
                      .rows = {}};
  if (figures.empty()) statement.title = Phrase::of("Not judged: no round is repeated");
  if (check.directionTest || check.verticalTest) statement.sentences.push_back(statedText(check));
  if (!passed && !figures.empty())
    statement.sentences.push_back(
        Phrase::of("State σ of a direction and of a zenith angle, as in the data sheet, for a verdict."));
  const auto warnings = std::ranges::count_if(
      findings, [](const Finding& finding) { return finding.severity != Severity::Note; });
  if (warnings > 0)
    statement.sentences.push_back(
        Phrase::of("Warnings to read before the instrument is used: %1.", warnings));
  return statement;
}

Statement identityTable(const CheckIdentity& identity) {
  Statement statement{.id = "identity",
                      .title = Phrase::of("Instrument"),
                      .columns = {{"what", "", Role::Name}, {"text", "", Role::Word}},
                      .rows = {}};
  const auto add = [&](const std::string& what, const std::string& text) {
    statement.rows.push_back({{what, text.empty() ? "—" : shortened(text, longestName)}});
  };
  add(Phrase::of("Name"), identity.name);
  add(Phrase::of("Serial number"), identity.serial);
  add(Phrase::of("Checked on"), identity.measuredOn);
  add(Phrase::of("Next check due"), identity.due);
  return statement;
}

Statement stationsTable(const InstrumentCheck& check) {
  const std::string ofDirection = Phrase::of(
                        "s of a direction observed once in both faces, with its degrees of freedom"),
                    ofZenith = Phrase::of(
                        "s of a zenith angle observed once in both faces, with its degrees of freedom");
  Statement statement{
      .id = "instrument_check",
      .title = Phrase::of("Field check after ISO 17123-3"),
      .columns = {{"station", Phrase::of("Station"), Role::Name,
                   Phrase::of("Each station is evaluated separately; the last row pools all stations")},
                  {"rounds", Phrase::of("Rounds"), Role::Figure, Phrase::of("Complete rounds × targets")},
                  {"s_direction", Phrase::of("s direction (ν)"), Role::Figure, ofDirection},
                  {"s_zenith", Phrase::of("s zenith (ν)"), Role::Figure, ofZenith},
                  {"collimation", Phrase::of("Collimation"), Role::Figure,
                   Phrase::of("c, with the sign of face 1, ± its standard uncertainty")},
                  {"index", Phrase::of("Index"), Role::Figure,
                   Phrase::of("Index of the vertical circle, sign of face 1, ± its standard uncertainty")},
                  {"tilt", Phrase::of("Trunnion tilt"), Role::Figure,
                   Phrase::of(
                       "i, estimated together with the collimation, from targets at several elevations")},
                  {"line_of_sight", Phrase::of("Line of sight"), Role::Figure,
                   Phrase::of("Offset e of the line of sight from the vertical axis, determined from targets "
                              "at several distances")}},
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
