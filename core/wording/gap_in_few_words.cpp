#include "core/wording/gap_in_few_words.h"

#include <algorithm>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/base/quantity_text.h"
#include "core/effects/cause_ids.h"
#include "core/wording/cause_name.h"
#include "core/wording/closures.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

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
  return Phrase::of("%1 is off by %2 σ", nameInWords(closure), sigmas);
}

std::string unknownCause(const Diagnosis& diagnosis) {
  if (diagnosis.causes.empty()) return Phrase::of("A gap of no known cause");
  if (diagnosis.causes.size() > 1)
    return Phrase::of("An unknown cause beside %1 known ones", diagnosis.causes.size());
  return Phrase::of("An unknown cause beside %1", causeName(diagnosis.causes.front().effect));
}

}  // namespace

std::string gapInFewWords(const Diagnosis& diagnosis) {
  switch (diagnosis.verdict) {
    case DiagnosisVerdict::WithinNoise:
      return isMisclosed(diagnosis) ? Phrase::of("The positions do not close")
                                    : Phrase::of("No gap: within the noise");
    case DiagnosisVerdict::SingleCause:
      return Phrase::of("One cause: %1", causeName(diagnosis.causes.front().effect));
    case DiagnosisVerdict::Ambiguous:
      return Phrase::of("One of %1 causes that look alike here",
                        diagnosis.causes.front().indistinguishableFrom.size() + 1);
    case DiagnosisVerdict::SeveralCauses:
      return diagnosis.hasMoreCausesThanSeparable
                 ? Phrase::of("More causes than these readings can take apart")
                 : Phrase::of("%1 causes", diagnosis.causes.size());
    case DiagnosisVerdict::NotInCatalogue:
      break;
  }
  return unknownCause(diagnosis);
}

std::string causesWithProbability(const Diagnosis& diagnosis) {
  constexpr std::size_t mostNamed = 3;
  std::vector<const Cause*> causes;
  for (const Cause& cause : diagnosis.causes)
    if (cause.effect != noiseId) causes.push_back(&cause);
  std::ranges::stable_sort(causes, std::ranges::greater(), &Cause::probability);
  std::vector<std::string> names;
  for (const Cause* cause : causes)
    //: a cause and its probability: "plane offset (72 %)"
    names.push_back(
        Phrase::of("%1 (%2)", causeName(cause->effect), shortProbabilityText(cause->probability)));
  const std::size_t more = names.size() - std::min(names.size(), mostNamed);
  names.resize(names.size() - more);
  if (more > 0) names.push_back(more == 1 ? Phrase::of("1 other") : Phrase::of("%1 others", more));
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
