#include "core/statement/sighting_choice.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/base/quantity_text.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/wording/effect_name.h"
#include "core/wording/guidance.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

std::string nameOf(const std::string& cause) {
  if (cause == formId) return Phrase::of("an effect of no catalogue");
  return cause.empty() ? Phrase::of("no cause") : causeName(cause);
}

std::string sightingText(std::size_t index, const ProtocolProgress& progress) {
  return sightingNameInSession(progress.sightings[index].planned);
}

std::string nextSentence(const SightingChoice& choice, const ProtocolProgress& progress) {
  const std::string next = sightingText(choice.next, progress);
  switch (choice.reason) {
    case SightingChoice::Reason::EarlyPlace:
      return Phrase::of(
          "Before the end, sight %1: an effect of time shows only if an early place is sighted again.", next);
    case SightingChoice::Reason::ClosingZero:
      return Phrase::of(
          "Before the end, sight %1: an effect of time shows only if the zero is sighted again.", next);
    case SightingChoice::Reason::TellsMost:
      break;
  }
  const NextSighting& worth = choice.worth;
  const std::string minutes = displayText(worth.minutes, 1);
  const auto& [cause, other] =
      worth.one.empty() ? std::tie(worth.other, worth.one) : std::tie(worth.one, worth.other);
  if (2 * worth.ofCauses > worth.worth())
    return Phrase::of("%1 is most informative for its %2 min: it separates %3 from %4.", next, minutes,
                      nameOf(cause), nameOf(other));
  return Phrase::of("%1 is most informative for its %2 min: it reduces U by %3.", next, minutes,
                    probabilityText(-std::expm1(-worth.ofUncertainty)));
}

std::string alternativesSentence(const SightingChoice& choice, const ProtocolProgress& progress) {
  std::vector<std::string> names;
  for (const std::size_t index : choice.alternatives) names.push_back(sightingText(index, progress));
  return names.empty() ? std::string()
                       : Phrase::of("Nearly as informative: %1.", listed(names, Phrase::of(" or ")));
}

/// The evidence from its natural logarithm: "2300", "4.5", "more than 1 000 000".
std::string evidenceText(double logEvidence) {
  constexpr double most = 13.8;  // ln 1 000 000
  if (logEvidence > most) return Phrase::of("more than 1 000 000");
  const double evidence = std::exp(logEvidence);
  return displayText(evidence, evidence < 10 ? 1 : 0);
}

/// The effects sought that no sighting of this protocol would show.
std::string notLookedForSentence(const SessionSoFar& state) {
  std::vector<std::string> names;
  for (const Effect* effect : soughtEffects())
    if (std::ranges::find(state.causes, effect->id, &WeighedCause::cause) == state.causes.end())
      names.push_back(causeName(std::string(effect->id)));
  return names.empty() ? std::string()
                       : Phrase::of("Not looked for, as this protocol cannot show it: %1.",
                                    listed(names, Phrase::of(" and ")));
}

}  // namespace

std::string enoughSentence(const SessionSoFar& state) {
  const std::string evidence = evidenceText(state.logEvidence);
  switch (state.enough) {
    case Enough::Named: {
      double probability = 0;
      for (const WeighedCause& cause : state.causes)
        if (std::ranges::find(state.named, cause.cause) != state.named.end())
          probability += cause.probability;
      if (state.named.front() == formId)
        return isEnough(state)
                   ? Phrase::of(
                         "Enough: there is an effect of no catalogue (%1); the diagnosis finds its form.",
                         probabilityText(probability))
                   : Phrase::of(
                         "There is an effect of no catalogue (%1), but Δd needs readings at both "
                         "positions.",
                         probabilityText(probability));
      if (!isEnough(state))
        return Phrase::of("The cause is named, %1 (%2), but Δd needs readings at both positions.",
                          causeNames(state.named, Phrase::of(" or ")), probabilityText(probability));
      return Phrase::of("Enough: the cause is named, %1 (%2); the evidence against no cause is %3 to 1.",
                        causeNames(state.named, Phrase::of(" or ")), probabilityText(probability), evidence);
    }
    case Enough::VerdictCertain:
      return state.isWithin
                 ? Phrase::of("Enough for a verdict: whatever effect is there, Δd is within the tolerance.")
                 : Phrase::of("Enough for a verdict: whatever effect is there, Δd is beyond the tolerance.");
    case Enough::WillNotHelp:
      return Phrase::of("More of these sightings will not help: none tells causes apart or reduces U.");
    case Enough::No:
      break;
  }
  if (state.logEvidence < state.logEvidenceNeeded)
    return Phrase::of("Not enough yet: the evidence against no cause is %1 to 1; %2 to 1 is needed.",
                      evidence, evidenceText(state.logEvidenceNeeded));
  if (state.causes.front().cause == noiseId)
    return Phrase::of(
        "Not enough yet: the readings scatter more than stated, from noise or an uncatalogued effect; the "
        "diagnosis shows which.");
  return Phrase::of("Not enough yet: the evidence against no cause is %1 to 1, but no cause stands out.",
                    evidence);
}

Statement sightingChoiceStatement(const SightingChoice& choice, const ProtocolProgress& progress) {
  using Role = Statement::Column::Role;
  Statement statement{
      .id = "next_sighting",
      .title = Phrase::of("What may be the case"),
      .columns = {{"cause", "", Role::Name}, {"probability", Phrase::of("probability"), Role::Figure}},
      .rows = {}};
  constexpr std::size_t most = 4;
  constexpr double least = 0.01;
  for (const WeighedCause& cause : choice.soFar.causes)
    if (statement.rows.size() < most && cause.probability >= least)
      statement.rows.push_back(
          {.cells = {withCapital(nameOf(cause.cause)), probabilityText(cause.probability)},
           .id = cause.cause});
  for (std::string sentence : {nextSentence(choice, progress), alternativesSentence(choice, progress),
                               enoughSentence(choice.soFar), notLookedForSentence(choice.soFar)})
    if (!sentence.empty()) statement.sentences.push_back(std::move(sentence));
  return statement;
}

}  // namespace alidade
