#include "core/certificate/quantity.h"

#include <charconv>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/phrase.h"

namespace alidade {

namespace {

/// Formats without an exponent, which the schema excludes for coverage factors and probabilities.
std::string withDecimals(double value, int decimals) {
  char text[400];
  const auto written = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
  const std::string number(text, written.ptr);
  return number.find_first_not_of("-0.") == std::string::npos && number.starts_with('-') ? number.substr(1)
                                                                                         : number;
}

constexpr int decimalsOfProbability = 4;

/// Adds an interval in place of U if k is below 1, which the schema excludes, or if a length minus U is
/// negative.
void addUncertainty(const Element& real, double value, const StatedUncertainty& stated, int decimals) {
  const double factor = stated.expanded / stated.sigma;
  const bool reachesZero = stated.isOfLength && value < stated.expanded;
  const bool isInterval = factor < 1 || reachesZero;
  const Element uncertainty = real.add(isInterval ? "si:coverageInterval" : "si:expandedUnc");
  if (isInterval) {
    const double least = value - stated.expanded;
    uncertainty.value("si:standardUnc", withDecimals(stated.sigma, decimalsFor(stated.sigma)));
    uncertainty.value("si:intervalMin", withDecimals(reachesZero ? 0 : least, decimals));
    uncertainty.value("si:intervalMax", withDecimals(value + stated.expanded, decimals));
  } else {
    constexpr int decimalsOfFactor = 3;
    uncertainty.value("si:uncertainty", stated.isTyped ? shortestText(stated.expanded)
                                                       : withDecimals(stated.expanded, decimals));
    uncertainty.value("si:coverageFactor", withDecimals(factor, decimalsOfFactor));
  }
  uncertainty.value("si:coverageProbability", withDecimals(stated.coverage, decimalsOfProbability));
  uncertainty.value("si:distribution", stated.distribution);
}

}  // namespace

StatedUncertainty standardUncertainty(double sigma) {
  const double withinOneSigma = std::erf(std::sqrt(0.5));  // of a normal distribution: 0.6827
  return {sigma, sigma, withinOneSigma};
}

StatedUncertainty typedUncertainty(double sigma) {
  StatedUncertainty stated = standardUncertainty(sigma);
  stated.isTyped = true;
  return stated;
}

double roundedTo(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

void addQuantity(const Element& to, const StatedQuantity& quantity, const char* element) {
  const Element own = to.add(element);
  if (quantity.id) own.attribute("id", quantity.id);
  if (quantity.refType) own.attribute("refType", quantity.refType);
  own.say("name", quantity.name);
  if (quantity.description) own.say("description", quantity.description);
  if (!std::isfinite(quantity.value)) {
    own.say("noQuantity", [] { return Phrase::of("not determined"); });
    return;
  }
  const Element real = own.add("si:real");
  const auto& uncertainty = quantity.uncertainty;
  const bool isUncertain = uncertainty && uncertainty->sigma > 0 && std::isfinite(uncertainty->expanded);
  const int decimals = isUncertain ? decimalsFor(uncertainty->expanded) : 0;
  real.value("si:value", isUncertain && !uncertainty->isTyped ? withDecimals(quantity.value, decimals)
                                                              : shortestText(quantity.value));
  real.value("si:unit", quantity.unit);
  if (isUncertain) addUncertainty(real, quantity.value, *uncertainty, decimals);
}

}  // namespace alidade
