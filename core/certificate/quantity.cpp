#include "core/certificate/quantity.h"

#include <charconv>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/phrase.h"

namespace alidade {

namespace {

/// Formats without an exponent, which the schema excludes for coverage factors and probabilities.
std::string plainText(double value) {
  char text[400];
  const auto written = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
  return {text, written.ptr};
}

/// Writes an equivalent interval for a coverage factor below 1, which the schema excludes.
void addUncertainty(const Element& real, double value, const StatedUncertainty& stated) {
  if (!(stated.sigma > 0) || !std::isfinite(stated.expanded)) return;
  const double factor = stated.expanded / stated.sigma;
  const bool isInterval = factor < 1;
  const Element uncertainty = real.add(isInterval ? "si:coverageInterval" : "si:expandedUnc");
  if (isInterval) {
    uncertainty.value("si:standardUnc", shortestText(stated.sigma));
    uncertainty.value("si:intervalMin", shortestText(value - stated.expanded));
    uncertainty.value("si:intervalMax", shortestText(value + stated.expanded));
  } else {
    uncertainty.value("si:uncertainty", shortestText(stated.expanded));
    uncertainty.value("si:coverageFactor", plainText(factor));
  }
  uncertainty.value("si:coverageProbability", plainText(stated.coverage));
  uncertainty.value("si:distribution", stated.distribution);
}

}  // namespace

StatedUncertainty standardUncertainty(double sigma) {
  const double withinOneSigma = std::erf(std::sqrt(0.5));  // of a normal distribution: 0.6827
  return {sigma, sigma, withinOneSigma};
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
  real.value("si:value", shortestText(quantity.value));
  real.value("si:unit", quantity.unit);
  if (quantity.uncertainty) addUncertainty(real, quantity.value, *quantity.uncertainty);
}

}  // namespace alidade
