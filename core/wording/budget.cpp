#include "core/wording/budget.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/wording/effect_name.h"

namespace alidade {

namespace {

double roundedTo(double value, int digits) {
  if (!(value > 0) || !std::isfinite(value)) return value;
  const double step = std::pow(10, std::floor(std::log10(value)) + 1 - digits);
  // A step below 1 is inexact in binary. Dividing by the whole number 1/step avoids its rounding error.
  return step < 1 ? std::round(value / step) / std::round(1 / step) : std::round(value / step) * step;
}

}  // namespace

std::string textOf(UncertaintySource source) {
  switch (source) {
    case UncertaintySource::Readings:
      return Phrase::of("readings");
    case UncertaintySource::ModelEffects:
      return Phrase::of("model effects");
    case UncertaintySource::PlausibleSizes:
      return Phrase::of("plausible sizes");
    case UncertaintySource::KnownRadius:
      return Phrase::of("known radius");
    case UncertaintySource::PointingZeros:
      return Phrase::of("pointing zeros");
    case UncertaintySource::Distance:
      return Phrase::of("distance");
  }
  return "";
}

std::string textOf(const UncertaintyShare& share) {
  if (share.source != UncertaintySource::PlausibleSizes) return textOf(share.source);
  return share.effect.empty() ? Phrase::of("other possible explanations") : share.effect;
}

std::string textOf(UncertaintyShare::From from) {
  switch (from) {
    case UncertaintyShare::From::Scatter:
      return Phrase::of("scatter");
    case UncertaintyShare::From::Stated:
      return Phrase::of("stated");
    case UncertaintyShare::From::Default:
      return Phrase::of("default");
    case UncertaintyShare::From::Known:
      return Phrase::of("known");
    case UncertaintyShare::From::Diagnosis:
      return Phrase::of("diagnosis");
  }
  return "";
}

std::string textOf(UncertaintyShare::Type type) {
  return type == UncertaintyShare::Type::A ? "A" : "B";
}

std::string numbersText(const UncertaintyShare& share) {
  // A default is scaled by what the session's other effects are like, which no third digit survives.
  const int digits = share.from == UncertaintyShare::From::Default ? 2 : 3;
  std::vector<std::string> numbers;
  for (const PlausibleSize& size : share.sizes) {
    std::string text = displayShortest(roundedTo(size.sigma, digits));
    if (numbers.empty() || numbers.back() != text) numbers.push_back(std::move(text));
  }
  return listed(numbers);
}

std::string sizesText(const UncertaintyShare& share) {
  const std::string numbers = numbersText(share);
  if (share.sizes.empty() || share.sizes.front().unit.size() < 2) return numbers;
  return numbers + " " + share.sizes.front().unit;
}

std::string sizesWithSign(const UncertaintyShare& share) {
  const std::string sign = share.sizes.empty() ? "" : signOf(share.sizes.front().unit);
  return sign.empty() ? sizesText(share) : numbersText(share) + sign;
}

std::string textOf(Beyond beyond) {
  switch (beyond) {
    case Beyond::Nothing:
      break;
    case Beyond::Pattern:
      return Phrase::of("with the pattern's possible effect");
    case Beyond::LookAlikes:
      return Phrase::of("averaged over the indistinguishable causes");
    case Beyond::Others:
      return Phrase::of("averaged over the possible explanations");
  }
  return "";
}

}  // namespace alidade
