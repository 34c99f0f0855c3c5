#include "core/series/instrument_check/instrument_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/answers/json_parts.h"
#include "core/answers/json_text.h"
#include "core/exchange/csv_text.h"
#include "core/series/instrument_check/check_statement.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

/// Formats degrees of freedom and counts as whole numbers.
Json whole(double value) {
  return static_cast<long long>(value);
}

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json slopeJson(const std::optional<RoundTrend>& slope) {
  if (!slope) return nullptr;
  return {{"per_round_arcsec", finite(slope->perRound)},
          {"u_arcsec", finite(slope->u)},
          {"dof", whole(slope->degreesOfFreedom)},
          {"p_value", finite(slope->pValue)}};
}

Json causesJson(const std::optional<TwoCauses>& causes, const char* name, const char* unit) {
  if (!causes) return nullptr;
  return {{std::string(name) + "_" + unit, finite(causes->other)},
          {std::string("u_") + name + "_" + unit, finite(causes->uOther)},
          {"collimation_arcsec", finite(causes->collimation)},
          {"u_collimation_arcsec", finite(causes->uCollimation)},
          {"correlation", finite(causes->correlation)},
          {"dof", whole(causes->degreesOfFreedom)},
          {"p_value", finite(causes->pValue)}};
}

Json courseJson(const StationCheck& station) {
  Json course = Json::array();
  for (const RoundCourse& round : station.course)
    course.push_back({{"round", round.name},
                      {"collimation_arcsec", finite(round.collimation)},
                      {"index_arcsec", finite(round.index)},
                      {"orientation_arcsec", finite(round.orientation)}});
  return course;
}

Json targetsJson(const StationCheck& station) {
  Json targets = Json::array();
  for (const TargetMean& target : station.perTarget)
    targets.push_back({{"target", target.name},
                       {"elevation_deg", finite(target.elevationDeg)},
                       {"distance_m", target.distanceM > 0 ? finite(target.distanceM) : Json(nullptr)},
                       {"collimation_arcsec", finite(target.collimation)},
                       {"index_arcsec", finite(target.index)}});
  return targets;
}

Json scatterJson(const CheckScatter& direction, const CheckScatter& vertical, const PairMean& collimation,
                 const PairMean& index) {
  return {{"s_direction_arcsec", finite(direction.s())},
          {"dof_direction", whole(direction.degreesOfFreedom)},
          {"s_zenith_arcsec", finite(vertical.s())},
          {"dof_zenith", whole(vertical.degreesOfFreedom)},
          {"collimation_arcsec", finite(collimation.value)},
          {"u_collimation_arcsec", finite(collimation.u)},
          {"index_arcsec", finite(index.value)},
          {"u_index_arcsec", finite(index.u)},
          {"dof_faces", whole(index.degreesOfFreedom)}};
}

const char* reasonName(LeftOut why) {
  switch (why) {
    case LeftOut::IncompleteRound:
      return "incomplete round";
    case LeftOut::RareTarget:
      return "rare target";
    case LeftOut::OneFace:
      return "one face";
    case LeftOut::FarApart:
      return "faces far apart";
    case LeftOut::Repeated:
      return "averaged";
  }
  return "";
}

Json stationJson(const StationCheck& station) {
  Json json = {{"station", station.station}, {"targets", station.targets}, {"rounds", station.rounds}};
  json.update(scatterJson(station.direction, station.vertical, station.collimation, station.index));
  json["trunnion_tilt"] = causesJson(station.causes.tilt, "tilt", "arcsec");
  json["line_of_sight"] = causesJson(station.causes.lineOfSight, "eccentricity", "mm");
  json["targets_differ_p_value"] = finite(station.targetsDifferP);
  json["drift"] = {{"collimation", slopeJson(station.collimationSlope)},
                   {"index", slopeJson(station.indexSlope)},
                   {"orientation", slopeJson(station.orientationSlope)}};
  json["circle_set_anew"] = station.isCircleReset;
  json["course"] = courseJson(station);
  json["by_target"] = targetsJson(station);
  json["left_out"] = Json::array();
  for (const LeftOutReadings& left : station.leftOut)
    json["left_out"].push_back(
        {{"why", reasonName(left.why)}, {"round", left.round}, {"target", left.target}});
  return json;
}

Json testJson(const std::optional<SigmaTest>& test) {
  if (!test) return nullptr;
  return {{"sigma_arcsec", finite(test->sigma)},
          {"limit_arcsec", finite(test->limit)},
          {"p_value", finite(test->pValue)},
          {"within", test->isWithin()}};
}

Json samplesJson(const InstrumentCheck& check) {
  Json samples = Json::array();
  for (const TwoSamples& sample : check.samples)
    samples.push_back({{"first", sample.first},
                       {"second", sample.second.empty() ? "all others" : sample.second},
                       {"direction_p_value", finite(sample.directionP)},
                       {"zenith_p_value", finite(sample.verticalP)}});
  return samples;
}

}  // namespace

std::string instrumentJson(const CheckIdentity& identity, const InstrumentCheck& check,
                           const std::vector<Finding>& findings, const std::vector<std::string>& remarks) {
  Json stations = Json::array();
  for (const StationCheck& station : check.stations) stations.push_back(stationJson(station));
  Json pooled = scatterJson(check.direction, check.vertical, check.collimation, check.index);
  pooled["trunnion_tilt"] = check.tilt ? Json{{"tilt_arcsec", finite(check.tilt->value)},
                                              {"u_tilt_arcsec", finite(check.tilt->u)},
                                              {"dof", whole(check.tilt->degreesOfFreedom)}}
                                       : Json(nullptr);
  pooled["line_of_sight"] = causesJson(check.lineOfSight, "eccentricity", "mm");
  pooled["collimations_differ_p_value"] = finite(check.collimationsDifferP);
  pooled["indices_differ_p_value"] = finite(check.indicesDifferP);
  const std::optional<bool> passed = hasPassed(check);
  const auto stated = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  return answerText(withLongNames({{"instrument", {{"name", identity.name}, {"serial", identity.serial}}},
                                   {"measured_on", stated(identity.measuredOn)},
                                   {"next_check_due", stated(identity.due)},
                                   {"verdict", !passed   ? "not_judged"
                                               : *passed ? "passed"
                                                         : "failed"},
                                   {"stations", std::move(stations)},
                                   {"pooled", std::move(pooled)},
                                   {"tests",
                                    {{"direction", testJson(check.directionTest)},
                                     {"zenith", testJson(check.verticalTest)},
                                     {"two_samples", samplesJson(check)}}},
                                   {"findings", findingsJson(findings)},
                                   {"remarks", remarks}}));
}

std::string instrumentCsv(const CheckIdentity& identity, const InstrumentCheck& check) {
  CsvText csv{"station",
              "round",
              "target",
              "direction_residual_arcsec",
              "zenith_residual_arcsec",
              "round_collimation_arcsec",
              "round_index_arcsec",
              "round_orientation_arcsec",
              "instrument",
              "instrument_serial",
              "measured_on"};
  for (const StationCheck& station : check.stations)
    for (const PairResidual& residual : station.residuals) {
      const RoundCourse& round = station.course[residual.round];
      csv.typed(station.station).typed(round.name).typed(station.perTarget[residual.target].name);
      csv.number(residual.direction).number(residual.vertical);
      csv.number(round.collimation).number(round.index).number(round.orientation);
      csv.typed(identity.name).typed(identity.serial).typed(identity.measuredOn).endRow();
    }
  return csv.text();
}

}  // namespace alidade
