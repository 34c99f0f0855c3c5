#include "core/answers/diagnosis_json.h"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "core/answers/json_parts.h"
#include "core/answers/json_text.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/measure.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

Json sizeJson(const GapSize& size) {
  return {{"rms_arcsec", size.rms}, {"reduced_chi2", size.reducedChiSquare}, {"p_value", size.pValue}};
}

Json readingJson(const ReadingDeviation& reading) {
  Json json = {{"axis_deg", reading.axisDeg},    {"round", reading.round},
               {"point", reading.point},         {"face", reading.face},
               {"circle", nameOf(reading.kind)}, {"size_arcsec", reading.size}};
  if (reading.repeat > 1) json["time"] = reading.repeat;
  if (reading.isZero) json["zero"] = reading.isAfter ? "after" : "before";
  return json;
}

/// Name of a centre coordinate or radius.
std::string_view nameOf(Unknown::Kind quantity) {
  if (quantity == Unknown::Kind::Radius) return "radius";
  return quantity == Unknown::Kind::CentreX ? "x" : "y";
}

Json closureJson(const ClosureStep& step) {
  Json json = {{"closure", nameOf(step.before.of)},
               {"value_mm", step.before.value},
               {"sigma_mm", step.before.sigma},
               {"sigmas", step.before.sigmas()},
               {"after_mm", step.after ? Json(step.after->value) : Json()},
               {"after_sigmas", step.after ? Json(step.after->sigmas()) : Json()}};
  if (const auto& repeated = step.before.repeated) {
    json["axis_deg"] = repeated->axisDeg;
    if (repeated->repeat > 1) json["time"] = repeated->repeat;
    if (step.before.isOfZeros())
      json["circle"] = step.before.of == Closure::Of::ZeroAzimuth ? "horizontal" : "vertical";
    else
      json["of"] = nameOf(repeated->quantity);
  }
  return json;
}

/// Rounds to 15 digits: the conversion of 25″ to radians and back changes digits beyond these.
double asTyped(double value) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, 15);
  std::from_chars(text.begin(), written.ptr, value);
  return value;
}

Json knownJson(const KnownCheck& check) {
  Json json = {
      {"effect", check.effect},
      {"parameter", check.name},
      {"unit", check.unit},
      {"known",
       {{"value", asTyped(check.known)}, {"sigma", asTyped(check.sigmaKnown)}, {"from", check.from}}},
      {"readings", nullptr},
      {"stale_probability", check.staleChance}};
  if (!check.date.empty()) json["known"]["date"] = check.date;
  if (check.isSeen) json["readings"] = {{"value", check.value}, {"sigma", check.sigma}};
  return json;
}

Json estimateJson(const std::optional<IntersectionEstimate>& estimate) {
  if (!estimate) return nullptr;
  return {{"value_mm", estimate->value}, {"sigma_mm", estimate->sigma}, {"expanded_mm", estimate->expanded}};
}

template <typename List, typename Make>
Json listJson(const List& list, const Make& make) {
  Json json = Json::array();
  for (const auto& entry : list) json.push_back(make(entry));
  return json;
}

}  // namespace

Json causeDocument(const Cause& cause) {
  Json parameters = Json::array(), readings = Json::array();
  for (const CauseParameter& parameter : cause.parameters)
    parameters.push_back({{"name", parameter.name},
                          {"value", parameter.value},
                          {"sigma", parameter.sigma},
                          {"unit", parameter.unit}});
  for (const ReadingDeviation& reading : cause.readings) readings.push_back(readingJson(reading));
  Json json = {{"effect", cause.effect},
               {"probability", cause.probability},
               {"parameters", parameters},
               {"indistinguishable_from", cause.indistinguishableFrom},
               {"readings", readings}};
  if (cause.isStale) json["stale"] = true;
  if (!cause.unlessStale.empty()) json["unless_stale"] = cause.unlessStale;
  return json;
}

std::string diagnosisJson(const std::string& session, const Diagnosis& diagnosis,
                          const std::vector<Finding>& findings, const std::string& digest) {
  return answerText(diagnosisDocument(session, diagnosis, findings), digest);
}

Json diagnosisDocument(const std::string& session, const Diagnosis& diagnosis,
                       const std::vector<Finding>& findings) {
  Json json;
  json["session"] = session;
  json["verdict"] = nameOf(diagnosis.verdict);
  json["sentence"] = sentenceOf(diagnosis);
  if (diagnosis.hasMoreCausesThanSeparable) json["more_causes_than_separable"] = true;
  json["gap"] = sizeJson(diagnosis.gap);
  json["after"] = sizeJson(diagnosis.after);
  json["shrink"] = {{"in_sample", diagnosis.shrink.inSample},
                    {"of_excess", diagnosis.shrink.ofExcess},
                    {"held_out", diagnosis.shrink.heldOut}};
  json["causes"] = listJson(diagnosis.causes, causeDocument);
  if (!diagnosis.known.empty()) json["known"] = listJson(diagnosis.known, knownJson);
  json["candidates"] = listJson(diagnosis.candidates, [](const Candidate& candidate) -> Json {
    return {{"effect", candidate.effect},
            {"log_bayes_factor", candidate.logBayesFactor},
            {"visible_sigma", candidate.visibleSigma}};
  });
  json["where"] = listJson(diagnosis.where, [](const GapShare& share) -> Json {
    return {{"by", share.by}, {"of", share.of}, {"share", share.share}};
  });
  json["steps"] = listJson(diagnosis.steps, [](const GapStep& step) -> Json {
    Json entry = sizeJson(step.size);
    entry["effect"] = step.effect;
    entry["intersection"] = estimateJson(step.intersection);
    return entry;
  });
  json["intersection"] = {{"before", estimateJson(diagnosis.before)},
                          {"after", estimateJson(diagnosis.afterwards)}};
  if (diagnosis.measured) json["intersection"]["as_found"] = estimateJson(diagnosis.measured->estimate);
  json["closures"] = listJson(diagnosis.closures, closureJson);
  if (!diagnosis.whatItWouldTake.empty())
    json["what_it_would_take"] = listJson(diagnosis.whatItWouldTake, [](const Required& required) -> Json {
      return {{"effect", required.effect},
              {"size", required.size},
              {"unit", required.unit},
              {"plausible_sizes", required.plausibleSizes},
              {"visible_sigma", required.visibleSigma}};
    });
  json["unseen"] = listJson(diagnosis.undetectable, [](const UndetectableEffect& effect) -> Json {
    return {{"effect", effect.effect},
            {"influence_mm", effect.influence},
            {"visible_sigma", effect.visibleSigma}};
  });
  json["advice"] = listJson(diagnosis.advice, [](const Advice& advice) -> Json {
    return {{"measure", textOf(advice.measures)},
            {"separates", advice.separates},
            {"by_sigma", advice.bySigma},
            {"one_left", advice.ofUndetectable ? Json() : Json(advice.oneLeft)},
            {"anew", isNewSessionNeeded(advice.measures)}};
  });
  json["attainable"] = attainableJson(diagnosis.attainable);
  if (diagnosis.shape)
    json["shape"] = {{"follows", diagnosis.shape->follows}, {"share", diagnosis.shape->share}};
  if (diagnosis.verdict == DiagnosisVerdict::NotInCatalogue || !diagnosis.forms.empty())
    json["forms"] = formsJson(diagnosis.forms);
  json["findings"] = findingsJson(findings);
  return json;
}

}  // namespace alidade
