#include "core/wording/series_words.h"

#include <algorithm>
#include <filesystem>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/wording/effect_name.h"
#include "core/wording/findings.h"
#include "core/wording/form_sentence.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

/// Has each session a size of its own, which no other session helps to know?
bool hasOwnSizes(const SharedCause& cause) {
  return !cause.sizes.empty() && !cause.isDrifting;
}

std::string ofOwner(const SharedCause& cause) {
  const std::string effect = causeName(cause.cause.effect);
  if (cause.owner == CauseOwner::Instrument && !cause.serial.empty())
    return Phrase::of("%1 of instrument %2", effect, cause.serial);
  if (cause.owner == CauseOwner::Guideway && !cause.serial.empty())
    return Phrase::of("%1 of guideway %2", effect, cause.serial);
  if (hasOwnSizes(cause)) return Phrase::of("%1, with its own size in each session", effect);
  return effect;
}

/// "a, b and 3 more".
std::string sessionsText(const std::vector<std::size_t>& sessions, const SeriesDiagnosis& series) {
  constexpr std::size_t most = 5;
  std::vector<std::string> names;
  for (const std::size_t s : sessions)
    if (names.size() < most) names.push_back(series.sessions[s].name);
  if (sessions.size() > most) names.push_back(Phrase::of("%1 more", sessions.size() - most));
  return listed(names, Phrase::of(" and "));
}

/// Whether the cause belongs to one session only.
bool isOfOne(const SharedCause& cause) {
  return cause.owner == CauseOwner::Time && cause.sizes.empty();
}

std::string unknownText(const SeriesDiagnosis& series, const std::vector<std::string>& shared) {
  const SharedPattern& pattern = *series.pattern;
  std::string text = Phrase::of("The sessions (%1) share a gap that no effect of the catalogue explains.",
                                pattern.sessions.size());
  if (pattern.isOfEach)
    text = Phrase::of("In most sessions (%1), each alone, no effect of the catalogue explains the gap.",
                      pattern.sessions.size());
  text = Phrase::of("%1 It follows a pattern: %2.", text, patternText(pattern));
  return shared.empty()
             ? text
             : Phrase::of("%1 In addition the sessions share %2.", text, listed(shared, Phrase::of(" and ")));
}

std::string together(const SeriesDiagnosis& series) {
  std::vector<std::string> shared;
  for (const SharedCause& cause : series.causes)
    if (!isOfOne(cause)) shared.push_back(ofOwner(cause));
  if (series.pattern) return unknownText(series, shared);
  if (shared.empty())
    return Phrase::of("The sessions (%1) share no effect that shows beyond their stated noise.",
                      series.sessions.size());
  std::string text = Phrase::of("The sessions (%1) together are best explained by %2.",
                                series.sessions.size(), listed(shared, Phrase::of(" and ")));
  for (const SharedCause& cause : series.causes) {
    if (isOfOne(cause)) continue;
    if (cause.isDrifting)
      text = Phrase::of(
          "%1 %2", text,
          Phrase::of("The size of %1 changes from session to session.", causeName(cause.cause.effect)));
    const auto& alike = cause.cause.indistinguishableFrom;
    if (alike.empty()) continue;
    text = Phrase::of("%1 %2", text,
                      Phrase::of("The sessions cannot distinguish %1 from %2.", causeName(cause.cause.effect),
                                 causeNames(alike, Phrase::of(" or "))));
  }
  if (series.unknownChance >= 0.01)
    text = Phrase::of(
        "%1 %2", text,
        Phrase::of("Probability of an uncatalogued effect: %1.", shortProbabilityText(series.unknownChance)));
  return text;
}

/// Returns the name of `file`, or its whole path if `other` has the same name.
std::string distinctName(const std::string& file, const std::string& other) {
  const std::filesystem::path name = std::filesystem::path(file).filename();
  return wellFormed(name == std::filesystem::path(other).filename() ? file : name.string());
}

}  // namespace

std::string patternText(const SharedPattern& pattern) {
  std::string text = Phrase::of(pattern.follows.c_str());
  if (pattern.order > 0) text = Phrase::of("%1 (%2 periods in a turn)", text, pattern.order);
  if (pattern.owner == CauseOwner::Instrument) return Phrase::of("%1, instrument %2", text, pattern.serial);
  if (pattern.owner == CauseOwner::Guideway) return Phrase::of("%1, guideway %2", text, pattern.serial);
  return text;
}

std::string ownerText(const SharedCause& cause) {
  switch (cause.owner) {
    case CauseOwner::Instrument:
      if (hasOwnSizes(cause)) return Phrase::of("the instrument of each session");
      return cause.serial.empty() ? Phrase::of("an instrument without serial number")
                                  : Phrase::of("instrument %1", cause.serial);
    case CauseOwner::Guideway:
      if (hasOwnSizes(cause)) return Phrase::of("the guideway of each session");
      return cause.serial.empty() ? Phrase::of("a guideway without serial number")
                                  : Phrase::of("guideway %1", cause.serial);
    case CauseOwner::Time:
      break;
  }
  return cause.sizes.empty() ? Phrase::of("the session by itself") : Phrase::of("each session by itself");
}

std::string sentenceOf(const SeriesDiagnosis& series) {
  constexpr std::size_t most = 5;
  std::string text = together(series);
  std::size_t shown = 0;
  for (const SharedCause& cause : series.causes) {
    if (!isOfOne(cause) || ++shown > most) continue;
    text = Phrase::of("%1 %2", text,
                      Phrase::of("%1 alone shows %2.", series.sessions[cause.sessions.front()].name,
                                 causeName(cause.cause.effect)));
  }
  for (const OfferedEffect& offered : series.offered) text = inTurn(text, sentenceOf(offered, series));
  return text;
}

std::string sentenceOf(const OfferedEffect& offered, const SeriesDiagnosis& series) {
  const FormNumber& amplitude = offered.form.parameters.back();
  const std::string u = sizeText(amplitude.sigma, amplitude.sigma, offered.form.form),
                    owner = offered.effect.device.empty()
                                ? Phrase::of("instrument %1", offered.effect.instrument)
                                : Phrase::of("guideway %1", offered.effect.device);
  return Phrase::of("Sessions of %1 show the same form, %2 (u %3): %4. The form can be kept as an effect.",
                    owner, textOf(offered.form), u, sessionsText(offered.sessions, series));
}

std::string sentenceOf(const SeriesAdvice& advice) {
  const std::string sigmas = displayText(advice.bySigma, 1);
  const std::string them = causeNames(advice.separates, Phrase::of(" and "));
  switch (advice.what) {
    case SeriesAdvice::What::OtherInstrument:
      return advice.instrument.empty()
                 ? Phrase::of(
                       "Measure guideway %1 with another instrument: separates %3 by %4 σ (sessions needed: "
                       "%2).",
                       advice.guideway, advice.sessions, them, sigmas)
                 : Phrase::of(
                       "Measure guideway %1 with instrument %2: separates %4 by %5 σ (sessions needed: %3).",
                       advice.guideway, advice.instrument, advice.sessions, them, sigmas);
    case SeriesAdvice::What::OtherGuideway:
      return advice.guideway.empty()
                 ? Phrase::of(
                       "Measure another guideway with instrument %1: separates %3 by %4 σ (sessions needed: "
                       "%2).",
                       advice.instrument, advice.sessions, them, sigmas)
                 : Phrase::of(
                       "Measure guideway %1 with instrument %2: separates %4 by %5 σ (sessions needed: %3).",
                       advice.guideway, advice.instrument, advice.sessions, them, sigmas);
    case SeriesAdvice::What::Again:
      if (!advice.instrument.empty())
        return Phrase::of(
            "Measure with instrument %1 in %2 more sessions: %3 would then be detectable at %4 σ.",
            advice.instrument, advice.sessions, them, sigmas);
      if (advice.guideway.empty())
        return Phrase::of("Measure %1 more sessions: %2 would then be detectable at %3 σ.", advice.sessions,
                          them, sigmas);
      return Phrase::of("Measure guideway %1 in %2 more sessions: %3 would then be detectable at %4 σ.",
                        advice.guideway, advice.sessions, them, sigmas);
  }
  return {};
}

std::string bothCirclesSentence() {
  return Phrase::of(
      "Some sessions have an elevation circle, others a zenith circle: all sizes of errors of the vertical "
      "circle are those on a zenith circle.");
}

std::vector<Finding> findingsOf(const SeriesDiagnosis& series) {
  std::vector<Finding> findings;
  const auto add = [&](std::string text, std::string remedy) {
    findings.push_back({.severity = Severity::Warning, .text = std::move(text), .remedy = std::move(remedy)});
  };
  for (const SeriesCopy& copy : series.copies)
    findings.push_back({.severity = Severity::Note, .text = copySentence(copy.file, copy.first)});
  if (series.hasBothCircles) findings.push_back({.severity = Severity::Note, .text = bothCirclesSentence()});
  if (series.withoutInstrument > 0)
    add(Phrase::of("%1 of %2 sessions do not state the serial number of their instrument: no instrument "
                   "effect is assumed to be common to them.",
                   series.withoutInstrument, series.sessions.size()),
        Phrase::of("Enter the serial numbers."));
  if (series.withoutGuideway > 0)
    add(Phrase::of("%1 of %2 sessions do not state the serial number of their guideway: no guideway effect "
                   "is assumed to be common to them.",
                   series.withoutGuideway, series.sessions.size()),
        Phrase::of("Enter the serial numbers."));
  for (const SharedCause& cause : series.causes) {
    std::vector<std::string> apart;
    for (const std::size_t s : cause.apart) apart.push_back(series.sessions[s].name);
    if (!apart.empty())
      add(Phrase::of("%2 has another size in %1 than in the other sessions.",
                     listed(apart, Phrase::of(" and ")), ofOwner(cause)),
          Phrase::of("See what was different in that session."));
  }
  return findings;
}

std::string copyReason(const std::string& copy, const std::string& first) {
  return Phrase::of("holds the same readings as %1: counted once", distinctName(first, copy));
}

std::string copySentence(const std::string& copy, const std::string& first) {
  return Phrase::of("%1 holds the same readings as %2: counted once.", distinctName(copy, first),
                    distinctName(first, copy));
}

}  // namespace alidade
