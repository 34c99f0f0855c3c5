#include "core/answers/series_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/answers/diagnosis_json.h"
#include "core/answers/json_parts.h"
#include "core/answers/json_text.h"
#include "core/wording/series_words.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

template <typename List, typename Make>
Json jsonOf(const List& list, const Make& make) {
  Json json = Json::array();
  for (const auto& entry : list) json.push_back(make(entry));
  return json;
}

Json parametersJson(const std::vector<CauseParameter>& parameters) {
  return jsonOf(parameters, [](const CauseParameter& parameter) -> Json {
    return {{"name", parameter.name},
            {"value", parameter.value},
            {"sigma", parameter.sigma},
            {"unit", parameter.unit}};
  });
}

Json causeJson(const SharedCause& cause, const SeriesDiagnosis& series) {
  const auto nameOfSession = [&](std::size_t s) -> Json { return series.sessions[s].name; };
  Json json = causeDocument(cause.cause);
  json["owner"] = nameOf(cause.owner);
  json["serial"] = cause.serial;
  json["sessions"] = jsonOf(cause.sessions, nameOfSession);
  json["drifting"] = cause.isDrifting;
  json["sizes"] = jsonOf(cause.sizes, [&](const SizeInSession& size) -> Json {
    return {{"session", series.sessions[size.session].name}, {"parameters", parametersJson(size.parameters)}};
  });
  json["not_in"] = jsonOf(cause.apart, nameOfSession);
  json["rivals"] = jsonOf(cause.rivals, [](const SharedRival& rival) -> Json {
    return {{"effect", rival.effect},
            {"owner", nameOf(rival.owner)},
            {"serial", rival.serial},
            {"odds", rival.odds}};
  });
  json["visible_sigma_each"] = cause.visibleInOne;
  json["visible_sigma_together"] = cause.visibleTogether;
  return json;
}

Json adviceJson(const SeriesAdvice& advice) {
  return {{"measure", sentenceOf(advice)},   {"separates", advice.separates}, {"by_sigma", advice.bySigma},
          {"instrument", advice.instrument}, {"guideway", advice.guideway},   {"sessions", advice.sessions}};
}

/// The `shape` of the shared pattern, and its owner.
Json shapeJson(const SeriesDiagnosis& series) {
  const SharedPattern& pattern = *series.pattern;
  return {
      {"follows", pattern.follows},
      {"share", pattern.share},
      {"order", pattern.order},
      {"owner", nameOf(pattern.owner)},
      {"serial", pattern.serial},
      {"sessions", jsonOf(pattern.sessions, [&](std::size_t s) -> Json { return series.sessions[s].name; })},
      {"of_each", pattern.isOfEach},
      {"probability", pattern.probability},
      {"visible_sigma_each", pattern.visibleInOne},
      {"visible_sigma_together", pattern.visibleTogether}};
}

Json offeredJson(const OfferedEffect& offered, const SeriesDiagnosis& series) {
  Json json = formDocument(offered.form);
  json["sessions"] = jsonOf(offered.sessions, [&](std::size_t s) -> Json { return series.sessions[s].name; });
  json["effect"] = ownEffectsJson({offered.effect}).front();
  return json;
}

/// Fills the keys of a session's diagnosis with the results of the series.
Json together(const std::string& name, const SeriesDiagnosis& series) {
  Diagnosis all;
  all.verdict = DiagnosisVerdict::WithinNoise;
  all.gap = series.gap;
  all.after = series.after;
  all.shrink = series.shrink;
  all.candidates = series.candidates;
  all.where = series.where;
  all.undetectable = series.undetectable;
  Json json = diagnosisDocument(name, all, findingsOf(series));
  json["verdict"] = nameOf(series.verdict);
  json["sentence"] = sentenceOf(series);
  json["causes"] = jsonOf(series.causes, [&](const SharedCause& cause) { return causeJson(cause, series); });
  if (series.pattern) json["shape"] = shapeJson(series);
  json["of_no_catalogue"] = series.unknownChance;
  json["advice"] = jsonOf(series.advice, adviceJson);
  json["offered_effects"] =
      jsonOf(series.offered, [&](const OfferedEffect& offered) { return offeredJson(offered, series); });
  return json;
}

/// The session's own document, with its place in the series.
Json sessionJson(const SeriesMember& member) {
  Json json = diagnosisDocument(member.name, member.diagnosis, {});
  json["measured_on"] = member.measuredOn;
  json["instrument"] = member.instrument;
  json["guideway"] = member.guideway;
  json["alone"] = {{"verdict", nameOf(member.alone)}, {"causes", jsonOf(member.causesAlone, causeDocument)}};
  json["known_from_series"] = jsonOf(member.shared, [](const KnownNumber& known) -> Json {
    return {{"effect", known.effect},
            {"parameter", known.parameter},
            {"value", known.value},
            {"sigma", known.sigma},
            {"unit", known.unit}};
  });
  json["own"] = jsonOf(member.own, causeDocument);
  return json;
}

}  // namespace

std::string seriesJson(const std::string& name, const SeriesDiagnosis& series) {
  return answerText({{"series", together(name, series)}, {"sessions", jsonOf(series.sessions, sessionJson)}});
}

}  // namespace alidade
