#include "core/answers/fit_json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/adjustment/joint/reliability.h"
#include "core/adjustment/result/input_reliability.h"
#include "core/adjustment/result/two_faces.h"
#include "core/answers/json_parts.h"
#include "core/answers/json_text.h"
#include "core/effects/cause_ids.h"
#include "core/session/value_text.h"
#include "core/statement/result_figures.h"
#include "core/wording/budget.h"
#include "core/wording/conditions.h"
#include "core/wording/findings.h"
#include "core/wording/suspects.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();  // written as null

/// The pointing zero, as the mean of its sightings.
Json zeroJson(const Measurement& measurement, const ArcMeasurement& arc) {
  const ZeroSightings& zero = arc.zero;
  Json moved = nullptr;
  if (zero.moved)
    moved = {{"horizontal_arcsec", zero.moved->horizontal.arcseconds()},
             {"vertical_arcsec", zero.moved->vertical.arcseconds()}};
  return {{"horizontal_deg", wrapped(arc.zeroHorizontal, Angle::fromDegrees(180)).degrees()},
          {"vertical_deg", arc.zeroVertical.degrees()},
          {"sightings", zero.count},
          {"both_faces", zero.isInBothFaces},
          {"sigma_horizontal_arcsec", measurement.sigmaOfZeroHorizontal(arc).arcseconds()},
          {"sigma_vertical_arcsec", measurement.sigmaOfZeroVertical(arc).arcseconds()},
          {"moved", std::move(moved)}};
}

Json arcJson(const ArcFit& arc, const ArcSigma& sigma) {
  Json json = {{"axis_deg", arc.axisDeg},
               {"center_mm", {{"x", arc.circle.x}, {"y", arc.circle.y}}},
               {"radius_mm", arc.circle.radius},
               {"sigma_mm", {{"x", sigma.x}, {"y", sigma.y}, {"radius", sigma.radius}}},
               {"correlation", {{"radius_x", sigma.radiusX}, {"radius_y", sigma.radiusY}}}};
  const ArcSummary summary = summaryOf(arc, sigma);
  for (const ArcFigure& figure : arcFigures()) {
    const double value = figure.value(summary);
    const bool isWhole = figure.isCount() && value == std::round(value);
    if (figure.key) json[figure.key] = isWhole ? Json(std::llround(value)) : Json(value);
  }
  json["iterations"] = arc.iterations;
  json["converged"] = arc.converged();
  if (arc.repeat > 1) json["time"] = arc.repeat;
  return json;
}

Json asPrintedJson(const AsPrinted& printed) {
  return {{"delta_radius_mm", printed.deltaRadius},
          {"x_mm", printed.x},
          {"y_mm", printed.y},
          {"theta_x_rad", printed.thetaX},
          {"theta_y_rad", printed.thetaY}};
}

Json intersectionJson(const Intersection& intersection) {
  return {{"value_mm", intersection.value},
          {"sigma_mm", intersection.sigma},
          {"expanded_mm", intersection.expanded},
          {"coverage", intersection.coverage},
          {"coverage_factor", intersection.coverageFactor},
          {"effective_degrees_of_freedom", intersection.effectiveDegreesOfFreedom},
          {"in_plane_mm", intersection.inPlane},
          {"in_plane_sigma_mm", intersection.inPlaneSigma},
          {"in_plane_expanded_mm", intersection.inPlaneExpanded}};
}

Json lengthJson(const std::optional<MeasuredLength>& length) {
  if (!length) return nullptr;
  return {{"value_mm", length->value}, {"sigma_mm", length->sigma}, {"expanded_mm", length->expanded}};
}

/// The same keys as `intersectionJson`, and the distribution. The part along x is null, and so are the
/// degrees of freedom of an average over several explanations of the readings.
Json asFoundJson(const IntersectionEstimate& found, double coverage) {
  return {
      {"value_mm", found.value},
      {"sigma_mm", found.sigma},
      {"expanded_mm", found.expanded},
      {"coverage", coverage},
      {"coverage_factor", found.sigma > 0 ? found.expanded / found.sigma : undefined},
      {"distribution", distributionOf(found)},
      {"effective_degrees_of_freedom", found.explanations.size() > 1 ? undefined : found.degreesOfFreedom},
      {"in_plane_mm", undefined},
      {"in_plane_sigma_mm", undefined},
      {"in_plane_expanded_mm", undefined}};
}

Json conditionsJson(const FitAnswer& answer, const AcceptanceDecision& decision) {
  Json conditions = Json::array();
  for (const std::size_t i : decision.conditions) {
    const UndetectableJump& jump = answer.diagnosis->undetectableJumps[i];
    double odds = 0;
    for (const NormalPart& move : jump.moves) odds += move.share;
    Json json = {{"effect", jumpId},
                 {"axis_deg", jump.axisDeg},
                 {"when", jump.isAfterZero ? "after_zero" : "during_readings"},
                 {"influence_mm", jump.influence},
                 {"probability", odds / (1 + odds)}};
    if (jump.repeat > 1) json["time"] = jump.repeat;
    conditions.push_back(std::move(json));
  }
  return conditions;
}

Json dependencesJson(const std::vector<Dependence>& dependences) {
  Json rows = Json::array();
  for (const Dependence& dependence : dependences) {
    rows.push_back({{"axis_deg", dependence.axisDeg},
                    {"round", dependence.round},
                    {"point", dependence.point},
                    {"face", dependence.face},
                    {"verdict", verdictName(dependence.without)},
                    {"by", dependence.isExact ? "re-evaluation" : "linear_estimate"}});
    if (dependence.repeat > 1) rows.back()["time"] = dependence.repeat;
  }
  return rows;
}

Json decisionJson(const FitAnswer& answer, const AcceptanceDecision& decision) {
  const bool isOpen = decision.verdict == Verdict::Undecided;
  return {{"tolerance_mm", answer.measurement.tolerance.value()},
          {"measurand", answer.measurement.measurand == Measurand::Distance ? "distance" : "intersection"},
          {"verdict", verdictName(decision.verdict)},
          {"conformance_probability", decision.conformance.value_or(undefined)},
          {"as_modelled", verdictName(decision.asModelled)},
          {"as_found", decision.asFound ? Json(verdictName(*decision.asFound)) : Json()},
          {"unexplained_probability", answer.diagnosis ? answer.diagnosis->unexplained.chance : undefined},
          {"unexplained_sigma_mm", answer.diagnosis ? answer.diagnosis->unexplained.sigma : undefined},
          {"conditions", conditionsJson(answer, decision)},
          {"condition_sentence", conditionSentence(answer.found(), decision)},
          {"depends_on", dependencesJson(answer.dependences)},
          {"depends_on_sentence", dependenceSentence(answer.dependences)},
          {"reason", isOpen ? verdictSentence(answer.measurement, answer.fit, answer.found(), decision)
                            : std::string()}};
}

Json budgetJson(const std::vector<BudgetEntry>& entries) {
  Json budget = Json::array();
  for (const BudgetEntry& entry : entries)
    budget.push_back({{"source", textOf(entry.source)}, {"sigma_mm", entry.sigma}});
  return budget;
}

Json sizeJson(const PlausibleSize& size) {
  return {{"name", size.name}, {"sigma", size.sigma}, {"unit", size.unit}};
}

Json budgetJson(const MeasuredIntersection& measured) {
  const double variance = measured.estimate.sigma * measured.estimate.sigma;
  Json budget = Json::array();
  for (const UncertaintyShare& share : measured.budget) {
    Json entry = {{"source", textOf(share)},
                  {"type", textOf(share.type)},
                  {"distribution", "normal"},
                  {"sigma_mm", share.sigma},
                  {"from", textOf(share.from)},
                  {"degrees_of_freedom", share.degreesOfFreedom},
                  {"share", variance > 0 ? share.sigma * share.sigma / variance : undefined}};
    if (!share.reference.empty()) entry["reference"] = share.reference;
    if (!share.sizes.empty()) {
      entry["sizes"] = Json::array();
      for (const PlausibleSize& size : share.sizes) entry["sizes"].push_back(sizeJson(size));
    }
    budget.push_back(std::move(entry));
  }
  return budget;
}

Json arcBudgetJson(const ArcBudget& budget) {
  return {{"x", budgetJson(budget.x)}, {"y", budgetJson(budget.y)}, {"radius", budgetJson(budget.radius)}};
}

Json effectJson(const EffectEstimate& estimate) {
  return {{"effect", estimate.effect},
          {"name", estimate.name},
          {"value", estimate.value},
          {"sigma", estimate.sigma},
          {"unit", estimate.unit}};
}

Json readingTestJson(const Detection& detection) {
  return {{"risk", detection.test.risk},
          {"power", detection.power},
          {"tests", detection.test.tests},
          {"degrees_of_freedom", std::max(detection.test.degreesOfFreedom, 0)},
          {"critical_value", detection.test.criticalValue()}};
}

std::string inputName(const Unknown& input) {
  if (input.kind == Unknown::Kind::HorizontalZero) return "horizontal_zero";
  if (input.kind == Unknown::Kind::VerticalZero) return "vertical_zero";
  return input.kind == Unknown::Kind::Radius ? "radius" : "distance";
}

Json inputJson(const InputReliability& reliability, const SessionFit& fit) {
  const bool isAngle = reliability.input.isPointingZero();
  const double unit = isAngle ? Angle::fromArcseconds(1).radians() : 1;
  Json json = {{"input", inputName(reliability.input)},
               {"unit", isAngle ? "arcsec" : "mm"},
               {"sigma", reliability.sigma / unit},
               {"redundancy", reliability.redundancy},
               {"minimal_detectable_bias", Json()},
               {"influence_mm_per_unit", fit.intersection ? reliability.perInput * unit : undefined}};
  if (!isAngle || reliability.input.arc == Unknown::everyArc) return json;
  const ArcFit& arc = fit.arcs[reliability.input.arc];
  json["axis_deg"] = arc.axisDeg;
  if (arc.repeat > 1) json["time"] = arc.repeat;
  return json;
}

Json inputsJson(const Measurement& measurement, const SessionFit& fit) {
  Json json = Json::array();
  for (const InputReliability& reliability : reliabilityOfInputs(measurement, fit))
    json.push_back(inputJson(reliability, fit));
  return json;
}

/// Adds the arrival in the notation of a session file.
void addArrival(Json& json, const Arrival* arrival) {
  if (!arrival) return;
  if (!arrival->takenAt.empty()) json["taken_at"] = arrival->takenAt;
  if (!arrival->returnCode.empty()) json["return_code"] = valueOf(arrival->returnCode, ValueKind::Number);
  if (!arrival->instrumentSerial.empty()) json["instrument_serial"] = arrival->instrumentSerial;
}

/// Names the row's position, round and point.
Json rowJson(int axisDeg, int repeat, const Sighting& sighting) {
  Json json = {{"axis_deg", axisDeg}};
  if (repeat > 1) json["time"] = repeat;
  json["round"] = sighting.round;
  json["point"] = sighting.point;
  return json;
}

Json reliabilityJson(const Measurement& measurement, const SessionFit& fit, const Detection& detection,
                     const std::vector<Arrival>& arrivals) {
  std::vector<const std::vector<Sighting>*> sightings;  // of each fitted arc
  for (const ArcFit& arc : fit.arcs)
    sightings.push_back(
        &std::ranges::find(measurement.arcs, arc.position, &ArcMeasurement::position)->sightings);
  Json list = Json::array();
  for (const AdjustedReading& reading : fit.joint.readings) {
    const Sighting& sighting = (*sightings[reading.arc])[reading.sighting];
    const Reliability reliability = reliabilityOf(reading, detection);
    const ArcFit& arc = fit.arcs[reading.arc];
    Json json = rowJson(arc.axisDeg, arc.repeat, sighting);
    json["face"] = sighting.face;
    json["circle"] = nameOf(reading.kind);
    json["residual_arcsec"] = Angle::fromRadians(reading.residual).arcseconds();
    json["standardised_residual"] = reading.standardised(detection.scale);
    json["redundancy"] = reading.redundancy;
    json["minimal_detectable_bias_arcsec"] = reliability.minimalDetectableBias.arcseconds();
    json["influence_mm"] = fit.intersection ? reliability.influence : undefined;
    addArrival(json, arrivalAt(arrivals, arc.position, sighting.row));
    list.push_back(std::move(json));
  }
  return list;
}

Json instrumentErrorJson(const InstrumentError& error) {
  return {{"value_arcsec", error.value.arcseconds()}, {"sigma_arcsec", error.sigma.arcseconds()}};
}

Json faceScatterJson(const FaceScatter& scatter) {
  return {{"of_stated", scatter.degreesOfFreedom > 0 ? scatter.ratio() : undefined},
          {"degrees_of_freedom", scatter.degreesOfFreedom}};
}

Json visitsJson(const Measurement& measurement, const TwoFaces& faces) {
  Json list = Json::array();
  for (const FaceDifference& visit : faces.visits) {
    const ArcMeasurement& arc = measurement.arcs[visit.arc];
    Json json = rowJson(arc.axisDeg, arc.repeat, arc.sightings[visit.faceOne]);
    json["elevation_deg"] = visit.elevation.degrees();
    json["double_collimation_arcsec"] = visit.doubleCollimation.arcseconds();
    json["from_course_arcsec"] = visit.fromCourse.arcseconds();
    json["index_arcsec"] = visit.index.arcseconds();
    list.push_back(std::move(json));
  }
  return list;
}

Json twoFacesJson(const Measurement& measurement, const TwoFaces& faces) {
  Json document = {{"collimation", instrumentErrorJson(faces.collimation)}};
  if (faces.trunnionTilt) document["trunnion_tilt"] = instrumentErrorJson(*faces.trunnionTilt);
  document["vertical_index"] = instrumentErrorJson(faces.index);
  document["scatter"] = {{"horizontal", faceScatterJson(faces.horizontal)},
                         {"vertical", faceScatterJson(faces.vertical)}};
  document["visits"] = visitsJson(measurement, faces);
  return document;
}

Json proposalJson(const Proposal& proposal) {
  Json changes = Json::array();
  for (const CellChange& change : proposal.changes)
    changes.push_back({{"where", change.where.path()}, {"text", change.text}});
  return {{"changes", std::move(changes)},
          {"residual_after_arcsec", proposal.residual.arcseconds()},
          {"share", proposal.share},
          {"sentence", sentenceOf(proposal)}};
}

Json suspectJson(const Suspect& suspect) {
  Json rivals = Json::array(), proposals = Json::array();
  for (const Place& rival : suspect.rivals) rivals.push_back(rival.path());
  for (const Proposal& proposal : suspect.proposals) proposals.push_back(proposalJson(proposal));
  Json json = {{"axis_deg", suspect.axisDeg},
               {"point", suspect.point},
               {"round", suspect.round},
               {"face", suspect.face},
               {"circle", nameOf(suspect.kind)},
               {"size_arcsec", suspect.size.arcseconds()},
               {"studentised", suspect.studentised},
               {"suggestion", sentenceOf(suspect)},
               {"where", suspect.where.path()},
               {"rivals", std::move(rivals)},
               {"proposals", std::move(proposals)}};
  if (suspect.repeat > 1) json["time"] = suspect.repeat;
  return json;
}

Json spreadJson(const Spread& spread) {
  return {
      {"mean_mm", spread.mean}, {"sigma_mm", spread.sigma}, {"low_mm", spread.low}, {"high_mm", spread.high}};
}

std::string linearName(LinearPropagation linear) {
  switch (linear) {
    case LinearPropagation::Validated:
      return "validated";
    case LinearPropagation::Refuted:
      return "refuted";
    case LinearPropagation::Undecided:
      break;
  }
  return "undecided";
}

Json monteCarloJson(const MonteCarlo& check) {
  Json json = {{"draws", check.draws},
               {"failed", check.failed},
               {"seed", check.seed},
               {"coverage", check.coverage},
               {"arcs", Json::array()}};
  for (const CentreSpread& centre : check.centres)
    json["arcs"].push_back(
        {{"axis_deg", centre.axisDeg}, {"x", spreadJson(centre.x)}, {"y", spreadJson(centre.y)}});
  if (!check.intersection) return json;
  json["intersection"] = spreadJson(*check.intersection);
  json["numerical_tolerance_mm"] = check.tolerance;
  json["low_difference_mm"] = check.lowDifference;
  json["high_difference_mm"] = check.highDifference;
  json["endpoint_sigma_mm"] = check.endpointSigma;
  json["linear_propagation"] = linearName(check.linear);
  return json;
}

}  // namespace

std::string fitJson(const FitAnswer& answer) {
  const Measurement& measurement = answer.measurement;
  const SessionFit& fit = answer.fit;
  Json document = {{"session", answer.session}, {"method", "rigorous"}, {"arcs", Json::array()}};
  for (std::size_t i = 0; i < fit.arcs.size(); ++i) {
    document["arcs"].push_back(arcJson(fit.arcs[i], fit.sigmas[i]));
    document["arcs"].back()["budget"] = arcBudgetJson(fit.budgets[i]);
    const auto read = std::ranges::find(measurement.arcs, fit.arcs[i].position, &ArcMeasurement::position);
    document["arcs"].back()["pointing_zero"] = zeroJson(measurement, *read);
  }
  document["noise_scale"] = fit.noise.factor;
  if (fit.intersection) document["intersection"] = intersectionJson(*fit.intersection);
  const auto measured = answer.diagnosis ? answer.diagnosis->measured : std::nullopt;
  if (measured) {
    document["intersection_measured"] = asFoundJson(measured->estimate, measurement.coverage);
    document["intersection_as_found"] = document["intersection_measured"];  // the name of earlier versions
    for (const MeasuredFigure& figure : measuredFigures())
      document[figure.id] = lengthJson((*measured).*figure.length);
  }
  if (const auto decision = decideAcceptance(measurement, fit, answer.found()))
    document["decision"] = decisionJson(answer, *decision);
  const Json ofFit = fit.intersection ? budgetJson(fit.intersection->budget) : Json::array();
  document["budget"] = measured ? budgetJson(*measured) : ofFit;
  if (measured) document["budget_of_fit"] = ofFit;
  if (answer.check) document["monte_carlo"] = monteCarloJson(*answer.check);
  document["effects"] = Json::array();
  for (const EffectEstimate& estimate : fit.effects) document["effects"].push_back(effectJson(estimate));
  const Detection detection = detectionIn(fit.joint, fit.noise.factor);
  document["reading_test"] = readingTestJson(detection);
  document["reliability"] = reliabilityJson(measurement, fit, detection, answer.arrivals);
  document["input_reliability"] = inputsJson(measurement, fit);
  if (const std::optional<TwoFaces> faces = compareFaces(measurement))
    document["two_faces"] = twoFacesJson(measurement, *faces);
  document["suspects"] = Json::array();
  for (const Suspect& suspect : answer.suspects) document["suspects"].push_back(suspectJson(suspect));
  document["findings"] = findingsJson(inWords(fit.findings, answer.suspects));
  return answerText(std::move(document), answer.digest);
}

std::string fitJson(const std::string& name, const Measurement& measurement, const PublishedSessionFit& fit,
                    const std::string& digest) {
  Json document = {{"session", name}, {"method", "published"}, {"arcs", Json::array()}};
  for (const PublishedFit& published : fit.arcs) {
    Json arc = arcJson(published.arc, {undefined, undefined, undefined, undefined, undefined});
    arc["as_printed"] = asPrintedJson(published.asPrinted);
    document["arcs"].push_back(std::move(arc));
  }
  if (fit.intersection)
    document["intersection"] = {
        {"value_mm", *fit.intersection}, {"sigma_mm", undefined},
        {"expanded_mm", undefined},      {"coverage", measurement.coverage},
        {"in_plane_mm", fit.inPlane},    {"as_printed_mm", fit.intersectionAsPrinted.value_or(undefined)}};
  document["budget"] = Json::array();
  document["suspects"] = Json::array();
  document["findings"] = findingsJson(inWords(fit.findings));
  return answerText(std::move(document), digest);
}

}  // namespace alidade
