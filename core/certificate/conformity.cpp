#include "core/certificate/measurement_results.h"

#include <cmath>
#include <optional>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/certificate/quantity.h"
#include "core/diagnosis/decision.h"
#include "core/statement/headline.h"
#include "core/wording/conditions.h"
#include "core/wording/findings.h"

namespace alidade {

namespace {

using Obstacle = AcceptanceDecision::Obstacle;

/// The best estimate of the size of the quantity to which the tolerance applies, mm, ≥ 0; absent if unknown.
std::optional<double> sizeAsFound(const FitAnswer& answer) {
  const Diagnosis* found = answer.found();
  if (!found) return std::abs(answer.fit.intersection->value);
  if (!found->measured) return std::nullopt;
  const MeasuredIntersection& measured = *found->measured;
  if (answer.measurement.measurand == Measurand::Intersection) return std::abs(measured.estimate.value);
  if (!measured.distance) return std::nullopt;
  return measured.distance->value;
}

std::optional<std::string_view> conditional(const FitAnswer& answer, const AcceptanceDecision& decision) {
  if (decision.obstacle != Obstacle::Uncertainty && decision.obstacle != Obstacle::Contradiction)
    return std::nullopt;
  if (answer.found() && isUnexplained(*answer.found())) return std::nullopt;
  const std::optional<double> found = sizeAsFound(answer);
  if (!found) return std::nullopt;
  const double tolerance = *answer.measurement.tolerance;
  const bool isWithin = *found <= tolerance;
  // The fit gives only one component of a distance from the axis: no comparison.
  if (answer.measurement.measurand == Measurand::Intersection &&
      (std::abs(answer.fit.intersection->value) <= tolerance) != isWithin)
    return std::nullopt;
  return isWithin ? "conditionalPass" : "conditionalFail";
}

std::string ruleText(const Measurement& measurement) {
  const std::string limit = displayShortest(*measurement.tolerance);
  const std::string share = displayPercent(measurement.coverage);
  if (measurement.measurand == Measurand::Distance)
    return Phrase::of(
        "Distance d of the arc's centre from the axis: pass if d + U ≤ %1 mm, measured, and |Δd| + U ≤ "
        "%1 mm, fit only; fail if d − U > %1 mm. Guard band w = U at a coverage of %2 %.",
        limit, share);
  return Phrase::of(
      "Intersection Δd, both measured and fit only: pass if |Δd| + U ≤ %1 mm, fail if |Δd| − U > %1 mm. "
      "Guard band w = U at a coverage of %2 %.",
      limit, share);
}

bool isConditional(const FitAnswer& answer) {
  return !headlineOf(answer.measurement, answer.fit, answer.found(), answer.dependences).condition().empty();
}

/// Says what the schema's word means for this result, or why there is no statement of conformity.
std::string statementText(const FitAnswer& answer) {
  const Headline headline = headlineOf(answer.measurement, answer.fit, answer.found(), answer.dependences);
  const std::string condition = headline.condition();
  const std::string sentence =
      inTurn(condition.empty() ? headline.sentence : Phrase::of("%1. %2", condition, headline.sentence),
             dependenceSentence(answer.dependences));
  const auto conformity = conformityOf(answer);
  if (!conformity) return Phrase::of("No statement of conformity. %1", sentence);
  if (headline.decided && *headline.decided != Verdict::Undecided) return sentence;
  if (*conformity == "conditionalPass")
    return Phrase::of(
        "Undecided: the value is within the tolerance, and the uncertainty reaches beyond it. %1", sentence);
  if (*conformity == "conditionalFail")
    return Phrase::of("Undecided: the value is beyond the tolerance, and the uncertainty reaches into it. %1",
                      sentence);
  return sentence;
}

void addNumbers(const Element& metaData, const FitAnswer& answer, const AcceptanceDecision& decision) {
  const Element data = metaData.add("data");
  addQuantity(data, {.id = "tolerance",
                     .name = [] { return Phrase::of("Tolerance"); },
                     .value = *answer.measurement.tolerance,
                     .unit = "\\milli\\metre"});
  if (decision.conformance)
    addQuantity(data, {.id = "conformance_probability",
                       .name = [] { return Phrase::of("Probability of conformance"); },
                       .value = roundedTo(*decision.conformance, 4)});
}

}  // namespace

std::optional<std::string_view> conformityOf(const FitAnswer& answer) {
  const auto decision = decideAcceptance(answer.measurement, answer.fit, answer.found());
  if (!decision || !answer.found()) return std::nullopt;
  switch (decision->verdict) {
    case Verdict::Accept:
      return isConditional(answer) ? "conditionalPass" : "pass";
    case Verdict::Reject:
      return isConditional(answer) ? "conditionalFail" : "fail";
    case Verdict::Undecided:
      break;
  }
  return conditional(answer, *decision);
}

void addConformity(const Element& metaData, const CertificateSource& source) {
  const FitAnswer& answer = source.answer;
  const Element own = metaData.add("metaData");
  own.attribute("id", "conformity").attribute("refType", "basic_conformity");
  own.say("name", [] { return Phrase::of("Statement of conformity"); });
  const auto decision = decideAcceptance(answer.measurement, answer.fit, answer.found());
  if (!decision) {
    own.say("declaration", [&] {
      return answer.measurement.tolerance
                 ? Phrase::of("No statement of conformity: there is no intersection to judge.")
                 : Phrase::of("No statement of conformity: no tolerance is stated.");
    });
    return;
  }
  const std::string agreed = certificateText(source.session.report.ruleAgreedBy);
  own.say("description", [&] {
    const std::string rule = ruleText(answer.measurement);
    return agreed.empty() ? rule : Phrase::of("%1 Agreed by: %2", rule, agreed);
  });
  own.value("norm", "JCGM 106:2012");
  own.value("norm", "ILAC-G8:09/2019");
  own.say("declaration", [&] { return statementText(answer); });
  if (const auto conformity = conformityOf(answer)) own.value("conformity", std::string(*conformity));
  addNumbers(own, answer, *decision);
}

}  // namespace alidade
