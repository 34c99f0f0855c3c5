#include "core/diagnosis/conclusion/causes.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/conclusion/misread_circle.h"
#include "core/effects/cause_ids.h"
#include "core/observation/reading_ref.h"

namespace alidade {

namespace {

void addParameters(Cause& cause, const GapModel& after, const Component& component) {
  const auto add = [&](std::string_view name, ErrorTerm term, std::string_view unit) {
    const std::size_t i = after.fit.indexOf({.kind = Unknown::Kind::Error, .arc = 0, .term = term});
    const double factor = modelUnitsPer(unit);
    cause.parameters.push_back({std::string(name), after.fit.values[i] / factor,
                                std::sqrt(after.fit.cofactor(i, i)) * after.noise / factor,
                                std::string(unit)});
  };
  if (component.kind == Component::Kind::Jump) {
    add("horizontal step", ErrorTerm::HorizontalJump, "arcsec");
    add("vertical step", ErrorTerm::VerticalJump, "arcsec");
    cause.parameters.push_back({"before row", static_cast<double>(component.moment) + 1, 0, "-"});
    return;
  }
  for (const EffectParameter& parameter : component.effect->parameters)
    add(parameter.name, parameter.term, parameter.unit);
}

Cause named(const Inquiry& inquiry, std::string_view id) {
  return {.effect = std::string(id),
          .probability = inquiry.probabilityOf(id),
          .parameters = {},
          .indistinguishableFrom = {},
          .readings = {}};
}

Cause largerNoise(const Inquiry& inquiry, const GapModel& after) {
  Cause cause = named(inquiry, noiseId);
  const double sigma = after.noise / std::sqrt(2.0 * std::max(1, after.fit.degreesOfFreedom));
  cause.parameters.push_back({"ratio", after.noise, sigma, "1"});
  return cause;
}

}  // namespace

std::vector<Cause> causesOf(const Inquiry& inquiry, const Answer& answer) {
  std::vector<Cause> causes;
  std::vector<BlamedReading> misread;
  for (const FarOff& far : inquiry.farOff) misread.push_back(blamed(inquiry, far.reading, far.sigmas));
  bool likeStep = false;
  const Explanation& explanation = answer.explanation;
  for (std::size_t p = 0; p < explanation.parts.size(); ++p) {
    const Part& part = explanation.parts[p];
    if (inquiry.isMisreading(part)) {
      misread.push_back(blamed(inquiry, inquiry.readingOf(part), part.weights[0]));
      likeStep = likeStep || !answer.rivals[p].empty();
      continue;
    }
    const Component& component = inquiry.candidates[part.component];
    Cause cause = named(inquiry, component.id);
    addParameters(cause, answer.after, component);
    for (const Rival& rival : answer.rivals[p])
      cause.indistinguishableFrom.emplace_back(inquiry.candidates[rival.part.component].id);
    causes.push_back(std::move(cause));
  }
  if (!misread.empty()) {
    Cause cause = named(inquiry, misreadingId);
    if (!inquiry.farOff.empty()) cause.probability = 1;
    // A step would stand for one row only.
    if (likeStep && misread.size() == 1) cause.indistinguishableFrom = {jumpId};
    cause.readings = withLikelierCircles(answer.after, std::move(misread));
    for (BlamedReading& reading : cause.readings)
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
    if (explanation.noisy && explanation.parts.empty()) offer(noiseId, explanation.logEvidence, 0);
    if (explanation.parts.size() != 1 || explanation.noisy || explanation.shaped) continue;
    const Part& part = explanation.parts[0];
    const double visible =
        inquiry.isMisreading(part)
            ? std::abs(part.weights[0]) * std::sqrt(inquiry.leftover.redundancy(inquiry.readingOf(part)))
            : std::sqrt(signatureSquare(inquiry.candidates[part.component], part.weights));
    offer(inquiry.idOf(part), part.logGain, visible);
  }
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& component = inquiry.candidates[i];
    if (component.kind != Component::Kind::Effect ||
        std::ranges::find(list, component.id, &Candidate::effect) != list.end())
      continue;
    const Part alone = fitAlone(inquiry.leftover, component, i);
    list.push_back(
        {std::string(component.id), alone.logGain, std::sqrt(signatureSquare(component, alone.weights))});
  }
  std::ranges::sort(list, std::greater{}, &Candidate::logBayesFactor);
  return list;
}

}  // namespace alidade
