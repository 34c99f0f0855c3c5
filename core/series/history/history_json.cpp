#include "core/series/history/history_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/adjustment/result/acceptance.h"
#include "core/answers/json_text.h"
#include "core/series/history/history_sentences.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

Json trendJson(const std::optional<HistoryTrend>& trend) {
  if (!trend) return {{"value", nullptr}, {"u", nullptr}};
  return {{"value", trend->perYear}, {"u", trend->u}, {"u_stated", trend->stated}};
}

Json stepJson(const History& history, const HistoryStep& step) {
  return {{"date", step.date},
          {"size", step.size},
          {"u", step.u},
          {"last_before", history.values[step.first - 1].date},
          {"earliest", history.values[step.earliest].date},
          {"latest", history.values[step.latest].date},
          {"values_before", step.valuesBefore},
          {"values_after", step.valuesAfter}};
}

Json chartJson(const History& history) {
  Json points = Json::array();
  for (const ControlChart::Point& point : history.chart.points)
    points.push_back({{"shewhart_limit", point.shewhart},
                      {"outside", point.isOut},
                      {"ewma", point.ewma},
                      {"ewma_limit", point.ewmaLimit},
                      {"ewma_outside", point.isEwmaOut}});
  return {{"centre", history.chart.centre},
          {"standard_uncertainty_centre", history.chart.centreU},
          {"baseline_values", history.chart.baseline},
          {"seen_sigma", history.chart.seenSigma},
          {"seen_limit", limitSigmas * history.chart.seenSigma},
          {"ewma_weight", ewmaWeight},
          {"points", points}};
}

Json valueJson(const DatedValue& value) {
  Json json = {
      {"date", value.date}, {"value", value.value}, {"u", value.u}, {"expanded_uncertainty", value.expanded}};
  if (value.apart != value.u) json["u_apart"] = value.apart;
  if (!value.of.empty()) json["session"] = value.of;
  return json;
}

/// One quantity over time: values, mean, χ², course and control chart.
Json seriesJson(const History& history, const std::string& unit) {
  Json values = Json::array(), steps = Json::array(), courses = Json::array();
  for (const DatedValue& value : history.values) values.push_back(valueJson(value));
  for (const HistoryStep& step : history.steps) steps.push_back(stepJson(history, step));
  for (const CourseProbability& course : history.courses)
    courses.push_back({{"course", nameOf(course.course)}, {"probability", course.probability}});
  Json json = {{"values", values},
               {"mean",
                {{"value", history.mean.value},
                 {"u", history.mean.u},
                 {"u_scattered", history.mean.scattered},
                 {"expanded_uncertainty", history.mean.expanded}}},
               {"chi2", history.chiSquare},
               {"dof", history.degreesOfFreedom},
               {"p_value", history.chance ? Json(*history.chance) : Json()},
               {"stable", history.stable ? Json(*history.stable) : Json()},
               {"steps", steps},
               {"trend_per_year", trendJson(history.trend)},
               {"birge_ratio", history.degreesOfFreedom > 0 ? Json(history.birgeRatio) : Json()},
               {"course", nameOf(history.course)},
               {"courses", courses},
               {"odd_value", history.oddValue ? Json(history.values[*history.oddValue].date) : Json()},
               {"chart", chartJson(history)},
               {"sentences", historySentences(history, unit)}};
  json["coverage"] = history.coverage;
  json["tolerance"] = history.tolerance ? Json(*history.tolerance) : Json();
  if (!unit.empty()) json["unit"] = unit;
  return json;
}

Json testJson(const std::optional<CongruenceTest>& test) {
  if (!test) return nullptr;
  Json differences = Json::object();
  for (std::size_t i = 0; i < test->ids.size(); ++i)
    differences[test->ids[i]] = {{"difference_mm", test->differences[i]}, {"u_mm", test->us[i]}};
  return {{"statistic", test->statistic},
          {"numbers", test->ids.size()},
          {"dof", test->degreesOfFreedom},
          {"p_value", test->chance},
          {"differences", differences}};
}

Json epochJson(const Epoch& epoch) {
  Json json = {{"session", epoch.title}, {"file", epoch.file}, {"date", epoch.date}};
  if (epoch.verdict) json["verdict"] = verdictName(*epoch.verdict);
  return json;
}

Json congruenceJson(const DeviceHistory& device, const Congruence& congruence) {
  return {{"first", epochJson(device.epochs[congruence.first])},
          {"second", epochJson(device.epochs[congruence.second])},
          {"difference", congruence.difference},
          {"u", congruence.u},
          {"expanded", congruence.expanded},
          {"p_value", congruence.chance},
          {"changed", congruence.hasChanged},
          {"device", testJson(congruence.device)},
          {"set_up", testJson(congruence.setUp)}};
}

Json deviceJson(const DeviceHistory& device) {
  const QuantityHistory& intersection = device.quantities.front();
  Json json = seriesJson(intersection.history, intersection.unit);
  json["device"] = {{"name", device.name}, {"serial", device.serial}};
  json["one_instrument"] = device.hasOneInstrument;
  json["sentences"].push_back(sharedSentence(device));
  json["quantities"] = Json::object();
  for (const QuantityHistory& quantity : device.quantities)
    json["quantities"][quantity.id] = seriesJson(quantity.history, quantity.unit);
  json["congruence"] = Json::array();
  for (const Congruence& congruence : device.congruences)
    json["congruence"].push_back(congruenceJson(device, congruence));
  return json;
}

Json instrumentHistoryJson(const InstrumentHistory& instrument) {
  Json json = {{"instrument", {{"name", instrument.name}, {"serial", instrument.serial}}}};
  json["records"] = Json::array();
  for (const KeptRecord& kept : instrument.records)
    json["records"].push_back({{"file", kept.file},
                               {"date", kept.record.date},
                               {"next_check_due", kept.record.due.empty() ? Json() : Json(kept.record.due)}});
  json["quantities"] = Json::object();
  for (const QuantityHistory& quantity : instrument.quantities)
    json["quantities"][quantity.id] = seriesJson(quantity.history, quantity.unit);
  return json;
}

Json named(const std::string& name, const Json& json) {
  Json all = {{"history", name}};
  all.update(json);
  return all;
}

}  // namespace

std::string historyJson(const std::string& name, const ValueTable& table, const History& history) {
  Json json = named(name, seriesJson(history, table.unit));
  json["remarks"] = table.remarks;
  return answerText(withLongNames(std::move(json)));
}

std::string historyJson(const std::string& name, const DeviceHistories& histories,
                        const std::vector<std::string>& remarks) {
  Json json;
  if (histories.devices.size() == 1) {
    json = named(name, deviceJson(histories.devices.front()));
  } else {
    json = {{"history", name}, {"devices", Json::array()}};
    for (const DeviceHistory& device : histories.devices) json["devices"].push_back(deviceJson(device));
  }
  json["remarks"] = remarks;
  return answerText(withLongNames(std::move(json)));
}

std::string historyJson(const std::string& name, const InstrumentHistories& histories,
                        const std::vector<std::string>& remarks) {
  Json json = {{"history", name}, {"instruments", Json::array()}};
  for (const InstrumentHistory& instrument : histories.instruments)
    json["instruments"].push_back(instrumentHistoryJson(instrument));
  json["remarks"] = remarks;
  for (const InstrumentHistory& instrument : histories.instruments)
    for (const std::string& sentence : instrument.leftOut) json["remarks"].push_back(sentence);
  return answerText(withLongNames(std::move(json)));
}

}  // namespace alidade
