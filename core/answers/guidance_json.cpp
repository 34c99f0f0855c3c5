#include "core/answers/guidance_answer.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/answers/json_parts.h"
#include "core/answers/json_text.h"
#include "core/statement/sighting_choice.h"
#include "core/wording/guidance.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

const char* idOf(SightingState state) {
  switch (state) {
    case SightingState::Taken:
      return "taken";
    case SightingState::Next:
      return "next";
    case SightingState::Missed:
      return "passed-over";
    case SightingState::Left:
      return "to-come";
    case SightingState::Excluded:
      return "excluded";
  }
  return "";
}

const char* idOf(SightingsToRepeat::Reason reason) {
  switch (reason) {
    case SightingsToRepeat::Reason::Misread:
      return "misread";
    case SightingsToRepeat::Reason::FacesDisagree:
      return "faces-disagree";
    case SightingsToRepeat::Reason::WaysDisagree:
      return "ways-disagree";
    case SightingsToRepeat::Reason::ZeroMoved:
      return "zero-moved";
  }
  return "";
}

Json sightingJson(const PlannedSighting& planned) {
  Json json = {{"axis_deg", planned.axisDeg}, {"time", planned.repeat}};
  if (planned.isZero)
    json["pointing_zero"] = planned.isAfter ? "after" : "before";
  else {
    json["point"] = planned.point;
    json["round"] = planned.round;
  }
  json["face"] = planned.face;
  return json;
}

const char* idOf(Enough enough) {
  switch (enough) {
    case Enough::No:
      return "not-yet";
    case Enough::Named:
      return "named";
    case Enough::VerdictCertain:
      return "verdict-certain";
    case Enough::WillNotHelp:
      return "will-not-help";
  }
  return "";
}

const char* idOf(SightingChoice::Reason reason) {
  switch (reason) {
    case SightingChoice::Reason::MostInformative:
      return "tells-most";
    case SightingChoice::Reason::EarlyPlace:
      return "early-place";
    case SightingChoice::Reason::ClosingZero:
      return "closing-zero";
  }
  return "";
}

Json causesJson(const std::vector<WeighedCause>& causes) {
  Json list = Json::array();
  for (const WeighedCause& cause : causes)
    list.push_back(
        {{"cause", cause.cause.empty() ? Json() : Json(cause.cause)}, {"probability", cause.probability}});
  return list;
}

Json choiceJson(const SightingChoice& choice, const ProtocolProgress& progress) {
  Json alternatives = Json::array();
  for (const std::size_t index : choice.alternatives)
    alternatives.push_back(sightingJson(progress.sightings[index].planned));
  Json json = {{"reason", idOf(choice.reason)}, {"minutes", choice.worth.minutes}};
  json["worth_of_causes"] = choice.worth.ofCauses;
  json["worth_of_uncertainty"] = choice.worth.ofUncertainty;
  json["alternatives"] = std::move(alternatives);
  json["enough"] = idOf(choice.soFar.enough);
  json["is_enough"] = isEnough(choice.soFar);
  json["log_evidence"] = choice.soFar.logEvidence;
  json["named"] = choice.soFar.named;
  json["also_named"] = choice.soFar.alsoNamed;
  json["causes"] = causesJson(choice.soFar.causes);
  json["further_causes"] = causesJson(choice.soFar.further);
  json["sentence"] = enoughSentence(choice.soFar);
  return json;
}

Json aheadJson(const SightingsAhead& ahead) {
  Json sightings = Json::array();
  for (const NextSighting& next : ahead.sightings)
    sightings.push_back({{"axis_deg", next.axisDeg},
                         {"turns_axis", next.turnsAxis},
                         {"point", next.point},
                         {"round", next.round},
                         {"face", next.face},
                         {"minutes", next.minutes}});
  Json json = {{"sightings", std::move(sightings)}, {"minutes", ahead.minutes}};
  json["expanded_uncertainty_mm"] = ahead.expanded ? Json(*ahead.expanded) : Json();
  json["reached"] = ahead.isReached;
  return json;
}

Json withExpected(Json json, const std::optional<ExpectedReading>& expected) {
  if (expected)
    json["expected"] = {{"horizontal_deg", expected->horizontal.degrees()},
                        {"vertical_deg", expected->vertical.degrees()},
                        {"within_arcsec", expected->tolerance.arcseconds()}};
  return json;
}

Json pairJson(const std::optional<ExpandedPair>& pair) {
  if (!pair) return nullptr;
  return {{"of_fit_mm", pair->ofFit},
          {"as_measured_mm", pair->asMeasured ? Json(*pair->asMeasured) : Json()}};
}

Json repeatJson(const SightingsToRepeat& toRepeat, const ProtocolProgress& progress) {
  Json sightings = Json::array();
  for (const std::size_t index : toRepeat.sightings)
    sightings.push_back(sightingJson(progress.sightings[index].planned));
  Json json = {{"reason", idOf(toRepeat.reason)}, {"sightings", std::move(sightings)}};
  json["circle"] = toRepeat.kind ? Json(nameOf(*toRepeat.kind)) : Json();
  json["size_arcsec"] = std::isfinite(toRepeat.size) ? Json(toRepeat.size) : Json();
  json["sigmas"] = toRepeat.sigmas;
  json["sentence"] = repeatSentence(toRepeat, progress);
  return json;
}

Json outlookJson(const Guidance& guidance) {
  const Outlook& outlook = guidance.outlook;
  Json ahead = Json::array();
  for (const RoundsAhead& one : outlook.ahead) {
    Json json = {{"rounds", one.rounds}};
    json["expanded"] = pairJson(one.expanded);
    json["enough"] = outlook.isEnough(one.expanded);
    ahead.push_back(std::move(json));
  }
  Json json = {{"now", pairJson(outlook.now)}};
  json["ahead"] = std::move(ahead);
  json["limit"] = pairJson(outlook.limit);
  json["needed"] = pairJson(outlook.needed);
  json["enough_now"] = outlook.now && outlook.isEnough(*outlook.now);
  const auto rounds = outlook.roundsNeeded();
  json["rounds_needed"] = rounds ? Json(*rounds) : Json();
  json["instead"] = attainableJson(outlook.instead);
  json["sentence"] = outlookSentences(outlook, guidance.progress);
  return json;
}

}  // namespace

std::string guidanceJson(const std::string& session, const Guidance& guidance, const std::string& digest) {
  const ProtocolProgress& progress = guidance.progress;
  Json sightings = Json::array(), allToRepeat = Json::array();
  for (std::size_t i = 0; i < progress.sightings.size(); ++i) {
    const FollowedSighting& followed = progress.sightings[i];
    Json json = sightingJson(followed.planned);
    json["state"] = idOf(followed.state);
    if (followed.isOutOfTurn) json["out_of_turn"] = true;
    sightings.push_back(withExpected(std::move(json), guidance.expected[i]));
  }
  for (const SightingsToRepeat& toRepeat : guidance.allToRepeat)
    allToRepeat.push_back(repeatJson(toRepeat, progress));
  Json json = {{"session", session}, {"protocol", guidance.protocol.name}};
  json["planned"] = progress.sightings.size();
  json["taken"] = progress.taken;
  json["left"] = progress.left();
  json["passed_over"] = progress.missed;
  json["excluded"] = progress.excluded;
  json["out_of_turn"] = progress.outOfTurn;
  json["beside"] = progress.unplanned;
  json["next"] = progress.next ? withExpected(sightingJson(progress.sightings[*progress.next].planned),
                                              guidance.expected[*progress.next])
                               : Json();
  if (guidance.ahead) json["ahead"] = aheadJson(*guidance.ahead);
  if (guidance.choice) json["choice"] = choiceJson(*guidance.choice, progress);
  json["repeat"] = std::move(allToRepeat);
  json["outlook"] = outlookJson(guidance);
  json["sightings"] = std::move(sightings);
  return answerText(std::move(json), digest);
}

}  // namespace alidade
