#include "core/wording/conditions.h"

#include <algorithm>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/effects/cause_ids.h"
#include "core/session/face.h"
#include "core/wording/closures.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/effect_name.h"
#include "core/wording/position_name.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

std::string rowText(const Dependence& row) {
  const std::string position = positionName(row.axisDeg, row.repeat);
  if (row.round == 1 && row.face == 1) return Phrase::of("%1 point %2", position, row.point);
  return Phrase::of("%1 point %2 (round %3, %4)", position, row.point, row.round, faceName(row.face));
}

std::string verdictText(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accept:
      return Phrase::of("accepted");
    case Verdict::Reject:
      return Phrase::of("rejected");
    case Verdict::Undecided:
      break;
  }
  return Phrase::of("undecided");
}

/// "undecided without 180° point 14 or …": the rows without which the verdict is `without`; may be empty.
std::string rowsText(const std::vector<Dependence>& dependences, Verdict without) {
  constexpr std::size_t mostNamed = 4;
  std::vector<std::string> rows;
  for (const Dependence& dependence : dependences)
    if (dependence.without == without) rows.push_back(rowText(dependence));
  if (rows.empty()) return "";
  const std::size_t more = rows.size() - std::min(rows.size(), mostNamed);
  rows.resize(rows.size() - more);
  if (more > 0) rows.push_back(Phrase::of("one of %1 others", more));
  return Phrase::of("%1 without %2", verdictText(without), listed(rows, Phrase::of(" or ")));
}

/// "misread values at 0°, point 5, vertical", "trunnion tilt different from its known value". The place is
/// added only if the cause has exactly one reading.
std::string causeWithPlace(const Cause& cause) {
  std::string name = causeName(cause.effect);
  //: a known size of an effect that the readings contradict: "trunnion tilt different from its known value"
  if (cause.isStale) name = Phrase::of("%1 different from its known value", name);
  return cause.readings.size() == 1 ? Phrase::of("%1 at %2", name, readingName(cause.readings.front()))
                                    : name;
}

std::string sigmasText(const Closure& closure) {
  constexpr double many = 10;
  return displayText(closure.sigmas(), closure.sigmas() < many ? 1 : 0);
}

std::string failureText(const Closure& closure) {
  const std::string sigmas = sigmasText(closure);
  switch (closure.of) {
    case Closure::Of::Radius:
      return Phrase::of("the radii differ by %1 σ", sigmas);
    case Closure::Of::Centre:
      return Phrase::of("Δx differs by %1 σ", sigmas);
    case Closure::Of::NominalRadius:
      return Phrase::of("R and R0 differ by %1 σ", sigmas);
    case Closure::Of::Reference:
      return Phrase::of("Δd and the reference differ by %1 σ", sigmas);
    case Closure::Of::ZeroAzimuth:
      return Phrase::of("the pointing zeros differ horizontally by %1 σ", sigmas);
    case Closure::Of::ZeroElevation:
      return Phrase::of("the pointing zeros differ vertically by %1 σ", sigmas);
    case Closure::Of::Repeat:
      break;
  }
  return Phrase::of("%1 differs from zero by %2 σ", nameInWords(closure), sigmas);
}

}  // namespace

std::string momentText(const UndetectableJump& jump) {
  const std::string position = positionName(jump.axisDeg, jump.repeat);
  return jump.isAfterZero ? Phrase::of("between the pointing zero and the first sighting at %1", position)
                          : Phrase::of("during the readings at %1", position);
}

ConditionalJump jumpConditionOf(const Diagnosis& diagnosis, const AcceptanceDecision& decision) {
  std::vector<std::string> moments;
  double influence = 0;
  for (const std::size_t i : decision.conditions) {
    moments.push_back(momentText(diagnosis.undetectableJumps[i]));
    influence = std::max(influence, diagnosis.undetectableJumps[i].influence);
  }
  return {listed(moments, Phrase::of(" or ")), displayText(influence, decimalsFor(influence))};
}

std::string conditionSentence(const Diagnosis* diagnosis, const AcceptanceDecision& decision) {
  if (!diagnosis || decision.conditions.empty()) return "";
  const auto [moments, influence] = jumpConditionOf(*diagnosis, decision);
  return Phrase::of(
      "The verdict holds on the condition that the tripod was not knocked %1. These readings cannot show "
      "such a knock; one of plausible size moves Δd by ± %2 mm. The probability of conformity includes a "
      "knock with its prior probability.",
      moments, influence);
}

std::string dependenceText(const std::vector<Dependence>& dependences) {
  if (dependences.empty()) return "";
  std::vector<std::string> parts;
  for (const Verdict without : {Verdict::Undecided, Verdict::Accept, Verdict::Reject})
    if (std::string rows = rowsText(dependences, without); !rows.empty()) parts.push_back(std::move(rows));
  return dependences.size() == 1
             ? Phrase::of("The verdict depends on a single row: %1", listed(parts))
             : Phrase::of("The verdict depends on each of these rows alone: %1", listed(parts));
}

std::string dependenceSentence(const std::vector<Dependence>& dependences) {
  const std::string text = dependenceText(dependences);
  return text.empty() ? text : Phrase::of("%1.", text);
}

std::vector<std::string> namedOrCounted(std::vector<std::string> names) {
  constexpr std::size_t mostNamed = 3;
  const std::size_t more = names.size() - std::min(names.size(), mostNamed);
  names.resize(names.size() - more);
  if (more > 0) names.push_back(more == 1 ? Phrase::of("1 other") : Phrase::of("%1 others", more));
  return names;
}

std::string causesWithProbability(const Diagnosis& diagnosis) {
  std::vector<const Cause*> causes;
  for (const Cause& cause : diagnosis.causes)
    if (cause.effect != noiseId) causes.push_back(&cause);
  std::ranges::stable_sort(causes, std::ranges::greater(), &Cause::probability);
  std::vector<std::string> names;
  for (const Cause* cause : causes)
    //: a cause and its probability: "plane offset (72 %)"
    names.push_back(Phrase::of("%1 (%2)", causeWithPlace(*cause), shortProbabilityText(cause->probability)));
  names = namedOrCounted(std::move(names));
  if (!names.empty() && diagnosis.verdict == DiagnosisVerdict::NotInCatalogue)
    names.push_back(Phrase::of("an unknown cause"));
  return listed(names, Phrase::of(" and "));
}

std::string failedClosures(const Diagnosis& diagnosis) {
  std::vector<std::string> failures;
  for (const ClosureStep& step : diagnosis.closures)
    if (fails(step.before)) failures.push_back(failureText(step.before));
  return listed(failures);
}

}  // namespace alidade
