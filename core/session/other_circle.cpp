#include "core/session/other_circle.h"

#include <utility>

#include "core/base/number_text.h"

namespace alidade {

std::optional<OnOtherCircle> onOtherCircle(std::string_view effect, std::string_view parameter) {
  const bool isSine = parameter == "sine";
  if (effect == "vertical_index" || effect == "vertical_drift")
    return OnOtherCircle{std::string(parameter), -1};
  if (effect == "vertical_circle_eccentricity") return OnOtherCircle{isSine ? "cosine" : "sine", -1};
  if (effect == "vertical_graduation") return OnOtherCircle{std::string(parameter), isSine ? -1.0 : 1.0};
  return std::nullopt;
}

std::vector<KnownSize> onOtherCircle(std::vector<KnownSize> known) {
  for (KnownSize& size : known) {
    auto other = onOtherCircle(size.effect, size.parameter);
    if (!other) continue;
    size.parameter = std::move(other->parameter);
    const Result<double> value = parseNumber(size.value);
    if (value && other->sign < 0) size.value = shortestText(*value == 0 ? 0 : -*value);
  }
  return known;
}

Measurement withZenithCircle(Measurement measurement) {
  if (measurement.verticalCircle == VerticalCircle::Zenith || measurement.own) return measurement;
  measurement.verticalCircle = VerticalCircle::Zenith;
  for (ArcMeasurement& arc : measurement.arcs)
    arc.zeroVertical = wrapped(Angle::fromDegrees(90) - arc.zeroVertical, Angle::fromDegrees(180));
  for (KnownNumber& size : measurement.known) {
    auto other = onOtherCircle(size.effect, size.parameter);
    if (!other) continue;
    size.parameter = std::move(other->parameter);
    size.value *= other->sign;
  }
  return measurement;
}

}  // namespace alidade
