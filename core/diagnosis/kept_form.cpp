#include "core/diagnosis/kept_form.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/session/own_effects.h"
#include "core/terms/formula.h"

namespace alidade {

namespace {

/// Rounds a size > 0 to two significant digits.
std::string rounded(double size) {
  const double exponent = std::floor(std::log10(size)) - 1, digit = std::pow(10, exponent);
  return fixedText(std::round(size / digit) * digit, std::max(0, static_cast<int>(-exponent)));
}

/// Returns the rms of the amplitudes: cosine and sine of a wave of any phase are equally plausible.
double plausibleOf(const FoundForm& found) {
  constexpr double least = 1e-3;  // mm or arcsec
  double squares = 0;
  for (const FormNumber& coefficient : found.coefficients) squares += coefficient.value * coefficient.value;
  const auto count = static_cast<double>(std::max<std::size_t>(found.coefficients.size(), 1));
  const double size = std::sqrt(squares / count);
  return std::isfinite(size) ? std::max(size, least) : least;
}

/// Splits a formula into one line for each carrier.
std::string linesOf(std::string formula) {
  constexpr std::string_view second = ", vertical = ";
  if (const std::size_t at = formula.find(second); at != std::string::npos) formula.replace(at, 2, "\n");
  return formula;
}

std::string plainName(const Form& form) {
  std::string name = std::string(nameOf(form.carrier)) + " " + std::string(nameOf(form.function));
  if (form.order > 0) name += " " + std::to_string(form.order);
  return name + " of " + std::string(nameOf(form.of));
}

}  // namespace

OwnEffect ownEffectOf(const FoundForm& found, const Session& session) {
  const bool isOfInstrument = isOfCircles(found.form.carrier);
  OwnEffect effect{.name = plainName(found.form), .formula = linesOf(found.formula)};
  effect.id = ownIdFrom(effect.name);
  (isOfInstrument ? effect.instrument : effect.device) =
      isOfInstrument ? session.instrument.serial : session.device.serial;
  const std::string plausible = rounded(plausibleOf(found));
  for (const FormNumber& coefficient : found.coefficients)
    effect.parameters.push_back({coefficient.name, plausible, found.form.isMillimetres() ? "mm" : "arcsec"});
  const std::string title = session.title.empty() ? Phrase::of("a session without a title") : session.title;
  effect.from = session.measuredOn.empty()
                    ? Phrase::of("found in %1", quotation(title))
                    : Phrase::of("found in %1 of %2", quotation(title), session.measuredOn);
  return effect;
}

}  // namespace alidade
