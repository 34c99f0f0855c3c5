#include "core/statement/sighting_choice.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/wording/effect_name.h"
#include "core/wording/guidance.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

std::string nameOf(const std::string& cause) {
  if (cause == formId) return Phrase::of("an uncatalogued effect");
  return cause.empty() ? Phrase::of("no cause") : causeName(cause);
}

/// A cause in addition to a certain cause: "with plane tilt"; "alone" if `cause` is empty.
std::string additionText(const std::string& cause) {
  return cause.empty() ? Phrase::of("alone") : Phrase::of("with %1", nameOf(cause));
}

std::string nextSentence(const SightingChoice& choice, const ProtocolProgress& progress) {
  const std::string next = sightingNameInSession(progress.sightings[choice.next].planned);
  switch (choice.reason) {
    case SightingChoice::Reason::EarlyPlace:
      return Phrase::of(
          "Before the end, sight %1: an effect of time shows only if an early place is sighted again.", next);
    case SightingChoice::Reason::ClosingZero:
      return Phrase::of(
          "Before the end, sight %1: an effect of time shows only if the zero is sighted again.", next);
    case SightingChoice::Reason::MostInformative:
      break;
  }
  const NextSighting& worth = choice.worth;
  const std::string minutes = displayText(worth.minutes, 1);
  const auto& [cause, other] =
      worth.one.empty() ? std::tie(worth.other, worth.one) : std::tie(worth.one, worth.other);
  const bool isOfCauses = 2 * worth.ofCauses > worth.worth();
  if (isOfCauses && other.empty() && !choice.soFar.further.empty())
    return Phrase::of(
        "%1 is most informative per minute (it takes %2 min): it shows whether %3 is also present.", next,
        minutes, nameOf(cause));
  if (isOfCauses)
    return Phrase::of("%1 is most informative per minute (it takes %2 min): it separates %3 from %4.", next,
                      minutes, nameOf(cause), nameOf(other));
  return Phrase::of("%1 is most informative per minute (it takes %2 min): it reduces U by %3.", next, minutes,
                    probabilityText(-std::expm1(-worth.ofUncertainty)));
}

std::string alternativesSentence(const SightingChoice& choice, const ProtocolProgress& progress) {
  std::vector<std::string> names;
  for (const std::size_t index : choice.alternatives)
    names.push_back(sightingNameInSession(progress.sightings[index].planned));
  return names.empty() ? std::string()
                       : Phrase::of("Nearly as informative: %1.", listed(names, Phrase::of(" or ")));
}

/// A Bayes factor from its natural logarithm: "2300", "4.5", "more than 1 000 000".
std::string evidenceText(double logEvidence) {
  constexpr double most = 13.8;  // ln 1 000 000
  if (logEvidence > most) return Phrase::of("more than 1 000 000");
  const double evidence = std::exp(logEvidence);
  return displayText(evidence, evidence < 10 ? 1 : 0);
}

/// "trunnion tilt or vertical index (97 %)".
std::string groupText(const std::vector<std::string>& group, const std::vector<WeighedCause>& causes) {
  std::vector<std::string> names;
  for (const std::string& cause : group) names.push_back(nameOf(cause));
  return Phrase::of("%1 (%2)", listed(names, Phrase::of(" or ")),
                    probabilityText(probabilityOf(group, causes)));
}

std::string secondSentence(const SessionSoFar& state) {
  const std::string second = groupText(state.alsoNamed, state.further);
  if (!isEnough(state))
    return Phrase::of("Two causes are identified, %1 and %2, but Δd needs readings at both positions.",
                      groupText(state.named, state.causes), second);
  return state.alsoNamed == state.named ? Phrase::of("Enough: the same cause occurs twice, %1.", second)
                                        : Phrase::of("Enough: two causes are identified, %1 and %2.",
                                                     groupText(state.named, state.causes), second);
}

std::string namedSentence(const SessionSoFar& state) {
  const std::string first = groupText(state.named, state.causes);
  if (state.named.front() == formId)
    return isEnough(state) ? Phrase::of("Enough: there is %1; the diagnosis finds its form.", first)
                           : Phrase::of("There is %1, but Δd needs readings at both positions.", first);
  if (!state.alsoNamed.empty()) return secondSentence(state);
  if (!isEnough(state))
    return Phrase::of("The cause is identified, %1, but Δd needs readings at both positions.", first);
  if (!state.isAlone)
    return Phrase::of("Enough: the cause is identified, %1; these sightings cannot show a further one.",
                      first);
  return Phrase::of("Enough: the cause is identified, %1; the Bayes factor for a cause is %2 to 1.", first,
                    evidenceText(state.logEvidence));
}

/// The sentence if a cause is certain, but the readings are not enough yet.
std::string evidentSentence(const SessionSoFar& state) {
  const std::string first = groupText(state.certain, state.causes);
  if (!state.named.empty())
    return Phrase::of("Not enough yet: %1 is identified, but the readings do not exclude a further cause.",
                      first);
  constexpr double unlikely = 0.05;
  return probabilityOf({""}, state.further) < unlikely
             ? Phrase::of(
                   "Not enough yet: %1 is evident and a further cause is present, but none is probable "
                   "enough to be identified.",
                   first)
             : Phrase::of(
                   "Not enough yet: %1 is evident; further readings show whether it is the only cause.",
                   first);
}

/// The effects sought that no sighting of this protocol would show.
std::string notLookedForSentence(const SessionSoFar& state) {
  std::vector<std::string> names;
  for (const Effect* effect : soughtEffects())
    if (std::ranges::find(state.causes, effect->id, &WeighedCause::cause) == state.causes.end())
      names.push_back(causeName(std::string(effect->id)));
  return names.empty() ? std::string()
                       : Phrase::of("Not looked for, because this protocol cannot show these effects: %1.",
                                    listed(names, Phrase::of(" and ")));
}

}  // namespace

std::string enoughSentence(const SessionSoFar& state) {
  const std::string evidence = evidenceText(state.logEvidence);
  switch (state.enough) {
    case Enough::Named:
      return namedSentence(state);
    case Enough::VerdictCertain:
      return state.isWithin
                 ? Phrase::of("Enough for a verdict: whatever effect is present, Δd is within the tolerance.")
                 : Phrase::of(
                       "Enough for a verdict: whatever effect is present, Δd is beyond the tolerance.");
    case Enough::WillNotHelp:
      return Phrase::of("More of these sightings will not help: none separates causes or reduces U.");
    case Enough::No:
      break;
  }
  if (!state.certain.empty()) return evidentSentence(state);
  if (state.logEvidence < state.logEvidenceNeeded)
    return Phrase::of("Not enough yet: the Bayes factor for a cause is %1 to 1; %2 to 1 is needed.", evidence,
                      evidenceText(state.logEvidenceNeeded));
  if (state.causes.front().cause == noiseId)
    return Phrase::of(
        "Not enough yet: the readings scatter more than stated, from noise or an uncatalogued effect; the "
        "diagnosis shows which.");
  return Phrase::of(
      "Not enough yet: the Bayes factor for a cause is %1 to 1, but no single cause is probable enough.",
      evidence);
}

Statement sightingChoiceStatement(const SightingChoice& choice, const ProtocolProgress& progress) {
  using Role = Statement::Column::Role;
  Statement statement{
      .id = "next_sighting",
      .title = Phrase::of("Possible explanations"),
      .columns = {{"cause", "", Role::Name}, {"probability", Phrase::of("probability"), Role::Figure}},
      .rows = {}};
  const SessionSoFar& soFar = choice.soFar;
  const auto add = [&](const std::vector<WeighedCause>& causes, std::size_t most, bool isPart) {
    constexpr double least = 0.01;
    for (std::size_t i = 0; i < std::min(most, causes.size()); ++i)
      if (causes[i].probability >= least)
        statement.rows.push_back(
            {.cells = {isPart ? additionText(causes[i].cause) : withCapital(nameOf(causes[i].cause)),
                       probabilityText(causes[i].probability)},
             .isPart = isPart,
             .id = causes[i].cause});
  };
  // The rows of further causes follow those of the certain one and its look-alikes.
  add(soFar.causes, soFar.certain.empty() ? 4 : soFar.certain.size(), false);
  add(soFar.further, 3, true);
  for (std::string sentence : {nextSentence(choice, progress), alternativesSentence(choice, progress),
                               enoughSentence(choice.soFar), notLookedForSentence(choice.soFar)})
    if (!sentence.empty()) statement.sentences.push_back(std::move(sentence));
  return statement;
}

}  // namespace alidade
