#include "core/wording/diagnosis_sentence.h"

#include <algorithm>
#include <cmath>

#include "core/base/list_text.h"
#include "core/base/quantity_text.h"
#include "core/effects/cause_ids.h"

namespace alidade {

namespace {

/// Larger noise explains residuals, it does not shrink them.
bool shrinks(const Diagnosis& diagnosis) {
  return diagnosis.causes.front().effect != noiseId;
}

std::string from(double before, double after, int decimals) {
  return "from " + displayText(before, decimals) + "″ to " + displayText(after, decimals) + "″";
}

/// Where the circles' σ differ much, χ² may fall while the residuals, in arcseconds, do not.
std::string change(const GapSize& before, const GapSize& after) {
  const auto differ = [&](int decimals) {
    return displayText(before.rms, decimals) != displayText(after.rms, decimals);
  };
  const std::string figures = from(before.rms, after.rms, differ(1) ? 1 : 2);
  if (after.rms < before.rms && differ(2)) return "the residuals shrink " + figures;
  const std::string residuals = differ(2) ? "grow " + figures : "stay at " + displayText(after.rms, 2) + "″";
  if (std::isnan(after.reducedChiSquare)) return "the residuals " + residuals;
  return "reduced χ² goes from " + displayText(before.reducedChiSquare, 2) + " to " +
         displayText(after.reducedChiSquare, 2) + "; the residuals, counted alike, " + residuals;
}

/// What the positions must agree on, and did not, they agree on with the causes.
bool closes(const Diagnosis& diagnosis) {
  const auto failed = [](const ClosureStep& step) { return fails(step.before); };
  return std::ranges::any_of(diagnosis.closures, failed) && !isMisclosed(diagnosis);
}

std::string shrunk(const Diagnosis& diagnosis) {
  const std::string& first = diagnosis.causes.front().effect;
  if (!shrinks(diagnosis))
    return " The readings scatter " + displayText(diagnosis.causes.front().parameters.front().value, 1) +
           " times as much as stated, without a pattern.";
  const std::string with = first == grossErrorId && diagnosis.causes.size() == 1
                               ? " Without the readings blamed "
                           : diagnosis.causes.size() == 1 ? " With it in the model "
                                                          : " With them in the model ";
  const std::string residuals = change(diagnosis.gap, diagnosis.after);
  if (!closes(diagnosis)) return with + residuals + ".";
  const bool changes = displayText(diagnosis.gap.rms, 1) != displayText(diagnosis.after.rms, 1);
  return with + "the two positions close" + (changes ? ", and " + residuals : std::string()) + ".";
}

std::string named(const std::vector<std::string>& ids, std::string_view last, const CauseNamer& name) {
  std::vector<std::string> names;
  for (const std::string& id : ids) names.push_back(name(id));
  return listed(names, last);
}

std::string causesNamed(const Diagnosis& diagnosis, const CauseNamer& name) {
  std::vector<std::string> ids;
  for (const Cause& cause : diagnosis.causes) ids.push_back(cause.effect);
  return named(ids, " and ", name);
}

}  // namespace

std::string byId(const std::string& id) {
  return id;
}

std::string sentenceOf(const Diagnosis& diagnosis, const CauseNamer& name) {
  switch (diagnosis.verdict) {
    case DiagnosisVerdict::WithinNoise:
      if (std::isnan(diagnosis.gap.pValue))
        return "Nothing checks the model: these readings just fix the circles and leave nothing over. Sight "
               "more places.";
      return "The readings agree with the model within their stated noise: there is no gap to explain.";
    case DiagnosisVerdict::SingleCause:
      return "The gap is best explained by " + causesNamed(diagnosis, name) + "." + shrunk(diagnosis);
    case DiagnosisVerdict::Ambiguous:
      return "The gap is best explained by " + causesNamed(diagnosis, name) +
             " or by what these readings cannot tell from it: " +
             named(diagnosis.causes.front().indistinguishableFrom, " or ", name) + "." + shrunk(diagnosis);
    case DiagnosisVerdict::SeveralCauses:
      return "The gap is best explained by several causes together: " + causesNamed(diagnosis, name) + "." +
             shrunk(diagnosis);
    case DiagnosisVerdict::NotInCatalogue:
      return (diagnosis.causes.empty()
                  ? "The gap is real, and no effect of the catalogue explains it"
                  : "Beside " + causesNamed(diagnosis, name) +
                        " the gap is real, and no effect of the catalogue explains the rest") +
             (diagnosis.shape ? "; it follows the pattern “" + diagnosis.shape->follows + "”."
                              : std::string("."));
  }
  return {};
}

}  // namespace alidade
