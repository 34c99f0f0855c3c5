#include "core/diagnosis/result/diagnosis.h"

#include <algorithm>

namespace alidade {

namespace {

bool isNewSessionNeededFor(Measure measure) {
  switch (measure) {
    case Measure::BothFaces:
    case Measure::WayBack:
    case Measure::SliderReadings:
    case Measure::MoreOfTheArc:
      return true;
    case Measure::ShiftedCircle:
    case Measure::SecondStandOff:
    case Measure::ZeroSightedAgain:
    case Measure::DistanceInBoth:
    case Measure::At0Again:
    case Measure::At180Again:
      return false;
  }
  return false;
}

}  // namespace

std::string_view nameOf(DiagnosisVerdict verdict) {
  switch (verdict) {
    case DiagnosisVerdict::WithinNoise:
      return "within-noise";
    case DiagnosisVerdict::SingleCause:
      return "single-cause";
    case DiagnosisVerdict::Ambiguous:
      return "ambiguous";
    case DiagnosisVerdict::SeveralCauses:
      return "several-causes";
    case DiagnosisVerdict::NotInCatalogue:
      return "not-in-catalogue";
  }
  return "";
}

bool isNewSessionNeeded(const std::vector<Measure>& measures) {
  return std::ranges::any_of(measures, isNewSessionNeededFor);
}

double effortOf(const std::vector<Measure>& measures) {
  double sessions = 0, times = 1;
  for (const Measure measure : measures) switch (measure) {
      case Measure::ZeroSightedAgain:
      case Measure::DistanceInBoth:
        sessions += 0.1;
        break;
      case Measure::SliderReadings:
        times *= 1.2;
        break;
      case Measure::At0Again:
      case Measure::At180Again:
        sessions += 0.5;
        break;
      case Measure::BothFaces:
      case Measure::WayBack:
        times *= 2;
        break;
      case Measure::MoreOfTheArc:
        times *= 1.5;
        break;
      case Measure::ShiftedCircle:
        sessions += 1.2;
        break;
      case Measure::SecondStandOff:
        sessions += 2;
        break;
    }
  return times > 1 ? sessions + times : sessions;
}

bool isMisclosed(const Diagnosis& diagnosis) {
  return std::ranges::any_of(diagnosis.closures, &ClosureStep::isOpen);
}

const char* distributionOf(const IntersectionEstimate& estimate) {
  if (estimate.explanations.size() > 1) return "mixture of Student's t";
  return std::isfinite(estimate.degreesOfFreedom) ? "Student's t" : "normal";
}

IntersectionEstimate estimateOf(const Intersection& intersection) {
  return {intersection.value,
          intersection.sigma,
          intersection.expanded,
          {{1, intersection.value, intersection.sigma}},
          intersection.effectiveDegreesOfFreedom};
}

Beyond beyondTheFit(const Diagnosis& diagnosis) {
  if (diagnosis.shape && diagnosis.forms.empty()) return Beyond::Pattern;
  const auto isAlone = [](const Cause& cause) { return cause.indistinguishableFrom.empty(); };
  if (!std::ranges::all_of(diagnosis.causes, isAlone)) return Beyond::LookAlikes;
  if (diagnosis.steps.empty() || !diagnosis.afterwards || !diagnosis.steps.back().intersection)
    return Beyond::Nothing;
  const bool isThatOfTheCauses =
      diagnosis.afterwards->expanded == diagnosis.steps.back().intersection->expanded;
  return isThatOfTheCauses ? Beyond::Nothing : Beyond::Others;
}

}  // namespace alidade
