#include "core/connection/circle_text.h"

#include "core/base/angle_text.h"
#include "core/base/number_text.h"

namespace alidade {

namespace {

constexpr int secondsDecimals = 3, degreeDecimals = 7;  // 0.001″ and 0.0004″

/// Removes trailing zeros after a decimal point, and a final point, from the number before `tail`.
std::string withoutNoughts(const std::string& text, const std::string& tail) {
  std::string number = text.substr(0, text.size() - tail.size());
  if (number.find('.') != std::string::npos) {
    while (number.back() == '0') number.pop_back();
    if (number.back() == '.') number.pop_back();
  }
  return number + tail;
}

}  // namespace

std::string circleText(Angle reading, CircleUnit unit) {
  if (unit == CircleUnit::Gon)
    return withoutNoughts(fixedText(reading.degrees() / 0.9, degreeDecimals) + "gon", "gon");
  if (unit == CircleUnit::Degrees)
    return withoutNoughts(fixedText(reading.degrees(), degreeDecimals) + "°", "°");
  return withoutNoughts(formatDms(reading, secondsDecimals, AngleSigns::Typewriter), "\"");
}

Angle onCircle(Angle zenith, VerticalCircle circle) {
  if (circle == VerticalCircle::Zenith) return zenith;
  const Angle elevation = Angle::fromDegrees(90) - zenith;
  return elevation.degrees() < -90 ? elevation + Angle::fromDegrees(360) : elevation;
}

Angle zenithOf(Angle reading, VerticalCircle circle) {
  if (circle == VerticalCircle::Zenith) return reading;
  const Angle zenith = Angle::fromDegrees(90) - reading;
  return zenith.degrees() < 0 ? zenith + Angle::fromDegrees(360) : zenith;
}

}  // namespace alidade
