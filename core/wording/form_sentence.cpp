#include "core/wording/form_sentence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/observation/reading_ref.h"
#include "core/wording/effect_name.h"
#include "core/wording/verdict.h"

namespace alidade {

std::string carrierText(const Form& form) {
  switch (form.carrier) {
    case FormCarrier::Radial:
      return Phrase::of("radius");
    case FormCarrier::Tangential:
      return Phrase::of("place along the arc");
    case FormCarrier::Across:
      return Phrase::of("guideway across its plane");
    case FormCarrier::X:
      return Phrase::of("target in x");
    case FormCarrier::Y:
      return Phrase::of("target in y");
    case FormCarrier::Z:
      return Phrase::of("target in z");
    case FormCarrier::Horizontal:
      return Phrase::of("horizontal readings");
    case FormCarrier::Vertical:
      return Phrase::of("vertical readings");
    case FormCarrier::Orientation:
      return Phrase::of("orientation");
    case FormCarrier::Slider:
      break;
  }
  return Phrase::of("slider readings");
}

namespace {

std::string symbolOf(FormArgument of) {
  if (of == FormArgument::HorizontalCircle) return "α";
  if (of == FormArgument::VerticalCircle) return "β";
  if (of == FormArgument::Leg) return Phrase::of("(1 there, −1 back)");
  if (of == FormArgument::Face) return Phrase::of("(1 in face 1, −1 in face 2)");
  if (of == FormArgument::Position) return Phrase::of("(1 at 0°, −1 at 180°)");
  return std::string(nameOf(of));
}

std::string numberText(const Form& form, std::size_t index) {
  constexpr double degree = std::numbers::pi / 180;
  return form.isOfAngle() ? displayText(form.numbers[index] / degree, 1) + "°"
                          : displayText(form.numbers[index], 3);
}

/// The functions that the amplitudes multiply: cosine and sine of a harmonic, otherwise a single one.
std::vector<std::string> functionTexts(const Form& form) {
  const std::string x = symbolOf(form.of);
  switch (form.function) {
    case FormFunction::Harmonic: {
      const std::string angle = form.of == FormArgument::T ? "2π·" + numberText(form, 0) + "t"
                                : form.order == 1          ? x
                                                           : std::to_string(form.order) + x;
      return {"cos " + angle, "sin " + angle};
    }
    case FormFunction::Bump:
      return {"exp(−½((" + x + " − " + numberText(form, 0) + ")/" + numberText(form, 1) + ")²)"};
    case FormFunction::Step:
      return {"[" + x + " > " + numberText(form, 0) + "]"};
    case FormFunction::Hinge:
      return {"max(0, " + x + " − " + numberText(form, 0) + ")" + (form.isOfAngle() ? "/10°" : "")};
    case FormFunction::Exponential:
      return {"exp(−" + x + "/" + numberText(form, 0) + ")"};
    case FormFunction::Power: {
      const std::string base = form.isOfAngle() ? "(" + x + "/10°)" : x;
      return {form.order == 1 ? base : base + (form.order == 2 ? "²" : "³")};
    }
    case FormFunction::Walk:
      return {Phrase::of("a random walk")};
    case FormFunction::PerPlace:
      return {Phrase::of("a separate value for each place")};
    case FormFunction::Hysteresis:
      break;
  }
  return {x};
}

std::string turningText(const Form& form, const std::string& text) {
  if (form.carrier <= FormCarrier::Across) return Phrase::of("%1, turning with the guideway", text);
  if (form.turnsWithFace) return Phrase::of("%1, with the other sign in face 2", text);
  return text;
}

std::string amplitudeText(const FormNumber& amplitude, const Form& form) {
  const std::string size = sizeText(std::abs(amplitude.value), amplitude.sigma, form);
  return (amplitude.value < 0 ? " − " : " + ") + size + " · ";
}

/// The term of a free form: its kind and the size of its coefficients.
std::string freeText(const FoundForm& found, const FormNumber& amplitude) {
  return " + " + Phrase::of("%1 (%2)", functionTexts(found.form).front(),
                            sizeText(std::abs(amplitude.value), amplitude.sigma, found.form));
}

/// The sum of the terms of one carrier, whose coefficients start at `first`.
std::string sumText(const FoundForm& found, std::size_t first) {
  if (found.form.isFree()) {
    const bool isFirstOfTwo = found.form.carrier == FormCarrier::Orientation && first == 0;
    return freeText(found, found.parameters[found.parameters.size() - (isFirstOfTwo ? 2 : 1)]);
  }
  std::string text;
  for (const std::string& function : functionTexts(found.form)) {
    text += amplitudeText(found.coefficients[first++], found.form) + function;
  }
  return text;
}

std::string percentText(double share) {
  return displayText(100 * share, 0);
}

}  // namespace

std::string sizeText(double value, double sigma, const Form& form) {
  return displayText(value, decimalsFor(sigma, 2)) + (form.isMillimetres() ? " mm" : "″");
}

std::string textOf(const FoundForm& found) {
  const Form& form = found.form;
  if (form.carrier != FormCarrier::Orientation)
    return turningText(form, carrierText(form) + sumText(found, 0));
  return Phrase::of("horizontal orientation%1, vertical orientation%2", sumText(found, 0),
                    sumText(found, found.coefficients.size() / 2));
}

std::string kindText(const Form& form) {
  std::string text = listed({carrierText(form), functionTexts(form).front()});
  return form.turnsWithFace && form.of != FormArgument::VerticalCircle
             ? Phrase::of("%1 with the other sign in face 2", text)
             : text;
}

std::string nameOf(const FormNumber& number) {
  const auto begins = [&](std::string_view name) { return number.name.starts_with(name); };
  if (begins("amplitude")) return Phrase::of("amplitude");
  if (begins("horizontal")) return inWords(ReadingKind::Horizontal);
  if (begins("vertical")) return inWords(ReadingKind::Vertical);
  if (begins("order")) return Phrase::of("order");
  if (begins("cycles")) return Phrase::of("cycles");
  if (begins("width")) return Phrase::of("width");
  return begins("at") ? Phrase::of("at") : "τ";
}

std::string unitOf(const FormNumber& number) {
  for (const char* const unit : {"mm", "arcsec", "deg"})
    if (number.name.ends_with(std::string("_") + unit)) return unit;
  return "1";
}

bool isExact(double value, double sigma) {
  constexpr double negligible = 1e-6;  // of |value|
  return !(sigma > negligible * std::abs(value));
}

std::string formSentence(const FoundForm& found) {
  return Phrase::of("The form: %1 (probability %2).", textOf(found), shortProbabilityText(found.probability));
}

std::string lookAlikesText(const FoundForm& found) {
  constexpr std::size_t most = 6;
  const std::size_t count = found.indistinguishableFrom.size();
  std::vector<std::string> kinds;
  for (const bool isEffect : {true, false})
    for (const FormLookAlike& other : found.indistinguishableFrom)
      if (other.effect.empty() != isEffect && kinds.size() < most)
        kinds.push_back(isEffect ? causeName(other.effect) : kindText(other.form));
  return count <= most ? listed(kinds) : Phrase::of("%1, and %2 more", listed(kinds), count - most);
}

std::string lookAlikesSentence(const FoundForm& found) {
  if (found.indistinguishableFrom.empty()) return {};
  return Phrase::of("These readings cannot distinguish the form from: %1.", lookAlikesText(found));
}

std::string cleanRangeSentence(const FoundForm& found) {
  const Form& form = found.form;
  if (form.function == FormFunction::Harmonic || form.function == FormFunction::Hysteresis) return {};
  const std::string x = symbolOf(form.of);
  if (found.cleanRange.empty())
    return Phrase::of("The form displaces readings by more than their σ over the whole range of %1.", x);
  const std::string unit = form.isOfAngle() ? "°" : "";
  const int decimals = form.isOfAngle() ? 0 : 2;
  std::vector<std::string> ranges;
  for (const auto& [from, to] : found.cleanRange)
    ranges.push_back(displayText(from, decimals) + unit + "…" + displayText(to, decimals) + unit);
  return Phrase::of(
      "The model holds where %1 is within %2: the form displaces readings there by less than their σ.", x,
      listed(ranges));
}

std::string shrinkSentence(const FoundForm& found) {
  const FormShrinkage& shrink = found.shrink;
  if (std::isnan(shrink.heldOut) || std::isnan(shrink.p)) return {};
  constexpr double least = 0.001;
  return Phrase::of(
      "On %1 readings held out of the fit, the form reduces the gap by %2 %; fitted to all readings, the "
      "form reduces the whole gap by %3 % (F test: p %4).",
      shrink.heldOutReadings, percentText(shrink.heldOut), percentText(shrink.inSample),
      shrink.p < least ? "< 0.001" : "= " + displayText(shrink.p, 3));
}

}  // namespace alidade
