#include "core/statement/reliability.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/adjustment/joint/reliability.h"
#include "core/adjustment/result/input_reliability.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/session/face.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;

constexpr std::size_t mostReadings = 5;

struct Rated {
  const AdjustedReading* adjusted;
  Reliability reliability;
};

std::string nameOf(const Measurement& measurement, const SessionFit& fit, const AdjustedReading& adjusted) {
  const std::size_t position = fit.arcs[adjusted.arc].position;
  const ArcMeasurement& arc = *std::ranges::find(measurement.arcs, position, &ArcMeasurement::position);
  const Sighting& sighting = arc.sightings[adjusted.sighting];
  std::vector<std::string> parts{positionName(arc.axisDeg, arc.repeat),
                                 Phrase::of("point %1", sighting.point)};
  if (sighting.round != 1) parts.push_back(Phrase::of("round %1", sighting.round));
  if (sighting.face != 1) parts.push_back(faceName(sighting.face));
  parts.push_back(inWords(adjusted.kind));
  return listed(parts);
}

std::string nameOf(const SessionFit& fit, const Unknown& input) {
  if (!input.isPointingZero())
    return input.kind == Unknown::Kind::Radius ? Phrase::of("known radius") : Phrase::of("distance");
  const std::string zero = input.kind == Unknown::Kind::HorizontalZero ? Phrase::of("horizontal zero")
                                                                       : Phrase::of("vertical zero");
  if (input.arc == Unknown::everyArc) return zero;
  return listed({positionName(fit.arcs[input.arc].axisDeg, fit.arcs[input.arc].repeat), zero});
}

std::string influenceText(const InputReliability& input, const SessionFit& fit) {
  if (!fit.intersection) return "—";
  if (!input.input.isPointingZero()) return Phrase::of("%1 per mm", displayText(input.perInput, 4));
  return Phrase::of("%1 per ″", displayText(input.perInput * Angle::fromArcseconds(1).radians(), 4));
}

/// Below this redundancy, an error shows only if it exceeds forty times the σ of its reading (Baarda 1968, α
/// 0.1 % and power 80 %: 4.13 σ/√r).
constexpr double leastRedundancy = 0.01;

/// The readings with the largest effect of an undetected error; the worst first.
std::vector<Rated> worstOf(const SessionFit& fit, const Detection& detection) {
  std::vector<Rated> rated;
  for (const AdjustedReading& adjusted : fit.joint.readings)
    rated.push_back({&adjusted, reliabilityOf(adjusted, detection)});
  const auto worst = rated.begin() + static_cast<std::ptrdiff_t>(std::min(mostReadings, rated.size()));
  const auto size = [](const Rated& one) { return std::abs(one.reliability.influence); };
  std::ranges::partial_sort(rated, worst, std::ranges::greater(), size);
  rated.erase(worst, rated.end());
  return rated;
}

std::string readingsSentence(const Measurement& measurement, const SessionFit& fit,
                             const Detection& detection, const std::vector<Rated>& worst) {
  if (!std::isfinite(detection.shift))
    return Phrase::of(
        "Too few readings: no reading is checked by the others well enough to show whether it is misread.");
  const auto isUnchecked = [](const AdjustedReading& adjusted) {
    return adjusted.redundancy < leastRedundancy;
  };
  if (const auto unchecked = std::ranges::count_if(fit.joint.readings, isUnchecked); unchecked > 0)
    return Phrase::of(
        "%1 of %2 readings are hardly checked by others (redundancy below %3): an error in them would not "
        "show.",
        unchecked, fit.joint.readings.size(), displayText(leastRedundancy, 2));
  if (!fit.intersection || !(std::abs(worst.front().reliability.influence) > 0))
    return Phrase::of("Every reading is checked.");
  const auto& [adjusted, reliability] = worst.front();
  return Phrase::of(
      "Every reading is checked. An undetected error has the largest effect in %1: an error of up to %2″ "
      "moves Δd by up to %3 mm.",
      nameOf(measurement, fit, *adjusted), displayText(reliability.minimalDetectableBias.arcseconds(), 0),
      displayText(std::abs(reliability.influence), 3));
}

std::string inputsSentence(const std::vector<InputReliability>& inputs) {
  const bool hasUncheckedZero = std::ranges::any_of(inputs, [](const InputReliability& input) {
    return input.input.isPointingZero() && !(input.redundancy > 0);
  });
  return hasUncheckedZero ? Phrase::of("Nothing checks the pointing zeros and the distance.")
                          : Phrase::of("Nothing checks the distance.");
}

}  // namespace

Statement reliabilityTable(const Measurement& measurement, const SessionFit& fit) {
  Statement statement{.id = "reliability",
                      .title = Phrase::of("Reliability"),
                      .columns = {{"reading", "", Role::Name},
                                  {"residual", Phrase::of("residual ″")},
                                  {"standardised", "w"},
                                  {"redundancy", Phrase::of("redundancy")},
                                  {"detectable", Phrase::of("detectable ″")},
                                  {"influence", Phrase::of("moves Δd by mm")}},
                      .rows = {}};
  if (fit.arcs.empty()) return statement;
  const Detection detection = detectionIn(fit.joint, fit.noise.factor);
  const std::vector<Rated> worst = worstOf(fit, detection);
  for (const auto& [adjusted, reliability] : worst) {
    const double bias = reliability.minimalDetectableBias.arcseconds();
    statement.rows.push_back(
        {{nameOf(measurement, fit, *adjusted),
          displayText(Angle::fromRadians(adjusted->residual).arcseconds(), 1),
          displayText(adjusted->standardised(detection.scale), 2), displayText(adjusted->redundancy, 2),
          std::isfinite(bias) ? displayText(bias, 1) : Phrase::of("none"),
          fit.intersection ? displayText(reliability.influence, 4) : "—"}});
  }
  const std::vector<InputReliability> inputs = reliabilityOfInputs(measurement, fit);
  for (const InputReliability& input : inputs)
    statement.rows.push_back({{nameOf(fit, input.input), "—", "—", displayText(input.redundancy, 2),
                               Phrase::of("none"), influenceText(input, fit)}});
  statement.sentences = {readingsSentence(measurement, fit, detection, worst), inputsSentence(inputs)};
  statement.note = Phrase::of(
      "w: standardised residual; redundancy: share of an error that shows in the residual; detectable: the "
      "smallest error that the search for misread readings finds with a probability of 80 %; moves Δd by: "
      "the effect of such an error.");
  return statement;
}

}  // namespace alidade
