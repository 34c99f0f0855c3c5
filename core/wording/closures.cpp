#include "core/wording/closures.h"

#include <cmath>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/statistics.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

std::string nameInWords(const Closure::Repeated& repeated) {
  const std::string quantity = repeated.quantity == Unknown::Kind::Radius    ? "R"
                               : repeated.quantity == Unknown::Kind::CentreX ? "Δx"
                                                                             : "Δy";
  return quantity + "(" + positionName(repeated.axisDeg, repeated.repeat) + ") − " + quantity + "(" +
         positionName(repeated.axisDeg) + ")";
}

/// The name of a misclosure of pointing zeros: "α0(180°) − first α0".
std::string nameOfZeros(const Closure& closure) {
  const Closure::Repeated later = closure.repeated.value_or(Closure::Repeated{180, 1, {}});
  const std::string position = positionName(later.axisDeg, later.repeat);
  return closure.of == Closure::Of::ZeroAzimuth ? Phrase::of("α0(%1) − first α0", position)
                                                : Phrase::of("β0(%1) − first β0", position);
}

}  // namespace

std::string nameInWords(const Closure& closure) {
  switch (closure.of) {
    case Closure::Of::Radius:
      return "R(180°) − R(0°)";
    case Closure::Of::Centre:
      return "Δx(180°) − Δx(0°)";
    case Closure::Of::NominalRadius:
      return "R − R0";
    case Closure::Of::Repeat:
      return nameInWords(closure.repeated.value_or(Closure::Repeated{}));
    case Closure::Of::Reference:
      return Phrase::of("Δd − reference");
    case Closure::Of::ZeroAzimuth:
    case Closure::Of::ZeroElevation:
      return nameOfZeros(closure);
  }
  return {};
}

std::string textOf(const Closure& closure) {
  const int decimals = decimalsFor(closure.sigma);
  return nameInWords(closure) + " = " + displayText(closure.value, decimals) + " mm (u " +
         displayText(closure.sigma, decimals) + "), " + displayText(closure.sigmas(), 1) + " σ";
}

double expandedOf(const Closure& closure, double coverage) {
  return coverageFactor(coverage, DegreesOfFreedom::infinite()) * closure.sigma;
}

std::string misclosureSentence(const Diagnosis& diagnosis) {
  std::vector<std::string> ofPositions, ofKnown;
  for (const ClosureStep& step : diagnosis.closures) {
    const Closure::Of of = step.before.of;
    const bool isOfPositions = of == Closure::Of::Radius || of == Closure::Of::Centre ||
                               of == Closure::Of::Repeat || step.before.isOfZeros();
    if (step.isOpen()) (isOfPositions ? ofPositions : ofKnown).push_back(textOf(step.latest()));
  }
  std::string text;
  if (!ofPositions.empty())
    text = Phrase::of(
        "The positions do not agree: %1. A movement between them may have changed Δd: find it, or measure "
        "again with new pointing zeros.",
        listed(ofPositions, Phrase::of(" and ")));
  if (!ofKnown.empty())
    text +=
        std::string(text.empty() ? "" : " ") + Phrase::of(
                                                   "The result disagrees with what is known: %1. Check the "
                                                   "known values, and find the cause of the difference.",
                                                   listed(ofKnown, Phrase::of(" and ")));
  return text;
}

bool isAcrossSignificant(const MeasuredIntersection& measured) {
  return measured.across && std::abs(measured.across->value) > measured.across->expanded;
}

std::string acrossSentence(const MeasuredIntersection& measured) {
  if (!measured.across)
    return Phrase::of(
        "The offset Δz of the arc's centre from the axis, perpendicular to the plane of the arc, was not "
        "measured.");
  const auto& [value, sigma, expanded] = *measured.across;
  return Phrase::of("The arc's centre is Δz = %1 off the axis, perpendicular to the plane of the arc.",
                    lengthWithUncertainty(value, expanded, decimalsFor(expanded)));
}

}  // namespace alidade
