#include "core/diagnosis/conclusion/causes.h"

#include <algorithm>
#include <cmath>

#include "core/base/phrase.h"
#include "core/diagnosis/conclusion/gross_error_circle.h"
#include "core/effects/cause_ids.h"
#include "core/observation/reading_ref.h"

namespace alidade {

namespace {

Cause named(const Inquiry& inquiry, std::string_view id) {
  return {.effect = std::string(id),
          .probability = inquiry.probabilityOf(id),
          .parameters = {},
          .indistinguishableFrom = {},
          .readings = {},
          .isStale = false,
          .unlessStale = {}};
}

Cause largerNoise(const Inquiry& inquiry, const GapModel& after) {
  Cause cause = named(inquiry, noiseId);
  const double sigma = after.noise / std::sqrt(2.0 * std::max(1, after.fit->degreesOfFreedom));
  //: true noise over the stated
  cause.parameters.push_back({PHRASE_LATER("Phrase", "ratio"), after.noise, sigma, "1"});
  return cause;
}

}  // namespace

DiagnosisVerdict verdictOf(const Answer& answer, const std::vector<Cause>& causes) {
  if (answer.kind == Answer::Kind::Unknown) return DiagnosisVerdict::NotInCatalogue;
  if (answer.kind == Answer::Kind::Several) return DiagnosisVerdict::SeveralCauses;
  if (causes.empty()) return DiagnosisVerdict::WithinNoise;
  if (causes.size() > 1) return DiagnosisVerdict::SeveralCauses;
  return causes.front().indistinguishableFrom.empty() ? DiagnosisVerdict::SingleCause
                                                      : DiagnosisVerdict::Ambiguous;
}

std::vector<Cause> causesOf(const Inquiry& inquiry, const Answer& answer) {
  std::vector<Cause> causes;
  std::vector<ReadingDeviation> grossErrors;
  for (const ExcludedReading& far : inquiry.excluded) grossErrors.push_back(far.deviation);
  bool likeJump = false;
  const Explanation& explanation = answer.explanation;
  for (std::size_t p = 0; p < explanation.parts.size(); ++p) {
    const Part& part = explanation.parts[p];
    const Component& component = inquiry.of(part);
    if (const auto reading = component.grossErrorAt()) {
      grossErrors.push_back(deviationAt(inquiry, *reading, part.weights[0]));
      likeJump = likeJump || !answer.rivals[p].empty();
      continue;
    }
    Cause cause = named(inquiry, component.id());
    cause.parameters = component.parameters(answer.after);
    cause.isStale = component.isKnown();
    for (const Rival& rival : answer.rivals[p]) {
      std::string id(inquiry.of(rival.part).id());
      std::vector<std::string>& alike = rival.isExcluded ? cause.unlessStale : cause.indistinguishableFrom;
      if (std::ranges::find(alike, id) == alike.end()) alike.push_back(std::move(id));
    }
    causes.push_back(std::move(cause));
  }
  if (!grossErrors.empty()) {
    Cause cause = named(inquiry, grossErrorId);
    if (!inquiry.excluded.empty()) cause.probability = 1;
    // A jump may look like one gross error, never like several.
    if (likeJump && grossErrors.size() == 1) cause.indistinguishableFrom = {jumpId};
    cause.readings = withLikelierCircles(answer.after, std::move(grossErrors));
    for (ReadingDeviation& reading : cause.readings)
      reading.size *= sideOf(*answer.after.measurement, reading.face, reading.kind);
    causes.push_back(std::move(cause));
  }
  if (explanation.noisy) causes.push_back(largerNoise(inquiry, answer.after));
  return causes;
}

std::vector<Candidate> candidatesOf(const Inquiry& inquiry) {
  std::vector<Candidate> list;
  const auto offer = [&](std::string_view id, double log, double visible) {
    const auto same = std::ranges::find(list, id, &Candidate::effect);
    if (same == list.end())
      list.push_back({std::string(id), log, visible});
    else if (same->logBayesFactor < log)
      *same = {std::string(id), log, visible};
  };
  for (const Explanation& explanation : inquiry.explanations) {
    if (explanation.noisy && explanation.parts.empty()) offer(noiseId, explanation.logBayesFactor, 0);
    if (explanation.parts.size() != 1 || explanation.noisy || explanation.shaped) continue;
    const Part& part = explanation.parts[0];
    const Component& component = inquiry.of(part);
    offer(component.id(), part.logGain, component.signatureLength(part.weights));
  }
  const SharedProducts residual(inquiry.leftover, inquiry.leftover.residual());
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& component = inquiry.candidates[i];
    if (!component.isEffect() || std::ranges::find(list, component.id(), &Candidate::effect) != list.end())
      continue;
    const Part alone = fitAlone(residual, component, i);
    list.push_back({std::string(component.id()), alone.logGain, component.signatureLength(alone.weights)});
  }
  std::ranges::sort(list, std::greater{}, &Candidate::logBayesFactor);
  return list;
}

}  // namespace alidade
