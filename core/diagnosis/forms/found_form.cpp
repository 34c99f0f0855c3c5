#include "core/diagnosis/forms/found_form.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "core/diagnosis/result/thresholds.h"

namespace alidade {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr double degree = std::numbers::pi / 180;

std::string shapeNumber(const Form& form, std::size_t index) {
  return form.isOfAngle() ? fixedText(form.numbers[index] / degree, 1) + "°"
                          : fixedText(form.numbers[index], 3);
}

std::string argumentText(FormArgument of) {
  if (of == FormArgument::HorizontalCircle) return "alpha";
  return of == FormArgument::VerticalCircle ? "beta" : std::string(nameOf(of));
}

/// The formula of the functions, with letters from `letter` on as coefficients.
std::string termsText(const Form& form, char letter) {
  const std::string x = argumentText(form.of), a(1, letter), face = form.turnsWithFace ? "face*" : "";
  switch (form.function) {
    case FormFunction::Harmonic: {
      const bool isOfTime = form.of == FormArgument::T;
      const std::string order = isOfTime ? "2*pi*" + shapeNumber(form, 0) : std::to_string(form.order);
      const std::string angle = order == "1" ? x : order + "*" + x;
      const std::string b(1, static_cast<char>(letter + 1));
      return face + a + "*cos(" + angle + ") + " + face + b + "*sin(" + angle + ")";
    }
    case FormFunction::Bump:
      return face + a + "*bump(" + x + ", " + shapeNumber(form, 0) + ", " + shapeNumber(form, 1) + ")";
    case FormFunction::Step:
      return face + a + "*step(" + x + ", " + shapeNumber(form, 0) + ")";
    case FormFunction::Hinge:
      return face + a + "*max(0, " + x + " - " + shapeNumber(form, 0) + ")" +
             (form.isOfAngle() ? "/10°" : "");
    case FormFunction::Exponential:
      return face + a + "*exp(-" + x + "/" + shapeNumber(form, 0) + ")";
    case FormFunction::Power:
      return face + a + "*" + (form.isOfAngle() ? "(" + x + "/10°)" : x) +
             (form.order > 1 ? "^" + std::to_string(form.order) : "");
    case FormFunction::Walk:
      return face + a + "*walk(" + x + ")";
    case FormFunction::PerPlace:
      return face + a + "[" + x + "]";
    case FormFunction::Hysteresis:
      break;
  }
  return face + a + "*" + x;
}

char letterAfter(const Form& form, char letter) {
  return static_cast<char>(letter + (form.function == FormFunction::Harmonic ? 2 : 1));
}

/// Adds the shape numbers in degrees or shares, with σ converted from `shapeCoordinates`.
void addShape(const WeighedForm& weighed, std::vector<FormNumber>& parameters) {
  const Form& form = weighed.form;
  const std::string unit = form.isOfAngle() ? "_deg" : "";
  const double per = form.isOfAngle() ? degree : 1;
  switch (form.function) {
    case FormFunction::Bump:
      parameters.push_back({"at" + unit, form.numbers[0] / per, weighed.sigmas[0] / per});
      parameters.push_back(
          {"width" + unit, form.numbers[1] / per, weighed.sigmas[1] * form.numbers[1] / per});
      return;
    case FormFunction::Step:
    case FormFunction::Hinge:
      parameters.push_back({"at" + unit, form.numbers[0] / per, weighed.sigmas[0] / per});
      return;
    case FormFunction::Exponential:
      parameters.push_back({"tau", form.numbers[0], weighed.sigmas[0] * form.numbers[0]});
      return;
    case FormFunction::Harmonic:
      if (form.of == FormArgument::T) parameters.push_back({"cycles", form.numbers[0], weighed.sigmas[0]});
      return;
    case FormFunction::Power:
    case FormFunction::Hysteresis:
    case FormFunction::Walk:
    case FormFunction::PerPlace:
      return;
  }
}

/// Standard uncertainty of the order: the spread of all possible orders about it.
double sigmaOfOrder(const Form& form, const std::vector<WeighedForm>& all) {
  double sum = 0, squares = 0;
  const double best = all.front().logPosterior();
  for (const WeighedForm& other : all) {
    if (!other.form.isOfKind(form)) continue;
    const double chance = std::exp(other.logPosterior() - best);
    sum += chance;
    squares += chance * std::pow(other.form.order - form.order, 2);
  }
  return sum > 0 ? std::sqrt(squares / sum) : 0;
}

/// A, B, … for each function; A[40.0°], … for each place; A[1/12], … for each step of a walk.
std::vector<std::string> coefficientNames(const FoundForm& found, Index count) {
  const Form& form = found.form;
  const std::size_t places = found.places.size();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const std::size_t place = form.isFree() ? i % places : 0;
    const std::string letter(1, static_cast<char>('A' + (form.isFree() ? i / places : i)));
    if (form.function == FormFunction::PerPlace)
      names.push_back(letter + "[" + fixedText(found.places[place] / degree, 1) + "°]");
    else if (form.function == FormFunction::Walk)
      names.push_back(letter + "[" + std::to_string(place + 1) + "/" + std::to_string(places) + "]");
    else
      names.push_back(letter);
  }
  return names;
}

/// The amplitude of one carrier: its only coefficient, or the root of the sum of its squared coefficients. A
/// form with a coefficient at each place has their rms as amplitude.
FormNumber amplitudeOf(const WeighedForm& weighed, Index first, Index count, const std::string& name) {
  const double per = weighed.form.function == FormFunction::PerPlace ? std::sqrt(double(count)) : 1;
  const VectorXd own = weighed.amplitudes.segment(first, count) / per;
  const Eigen::MatrixXd covariance = weighed.covariance.block(first, first, count, count) / (per * per);
  if (count == 1) return {name, own[0], std::sqrt(covariance(0, 0))};
  const double size = own.norm();
  const VectorXd along = size > 0 ? VectorXd(own / size) : VectorXd::Unit(count, 0);
  return {name, size, std::sqrt(along.dot(covariance * along))};
}

}  // namespace

std::string formulaOf(const Form& form) {
  if (form.carrier != FormCarrier::Orientation)
    return std::string(nameOf(form.carrier)) + " = " + termsText(form, 'A');
  return "horizontal = " + termsText(form, 'A') + ", vertical = " + termsText(form, letterAfter(form, 'A'));
}

FoundForm foundForm(const WeighedForm& weighed, const std::vector<WeighedForm>& all) {
  const Form& form = weighed.form;
  FoundForm found{.form = form, .formula = formulaOf(form)};
  found.places = weighed.places;
  const Index count = weighed.amplitudes.size();
  const std::vector<std::string> names = coefficientNames(found, count);
  for (Index i = 0; i < count; ++i)
    found.coefficients.push_back(
        {names[static_cast<std::size_t>(i)], weighed.amplitudes[i], std::sqrt(weighed.covariance(i, i))});
  if (form.order > 0)
    found.parameters.push_back({"order", static_cast<double>(form.order), sigmaOfOrder(form, all)});
  addShape(weighed, found.parameters);
  if (form.carrier == FormCarrier::Orientation) {
    found.parameters.push_back(amplitudeOf(weighed, 0, count / 2, "horizontal_arcsec"));
    found.parameters.push_back(amplitudeOf(weighed, count / 2, count / 2, "vertical_arcsec"));
  } else {
    const std::string name = form.isMillimetres() ? "amplitude_mm" : "amplitude_arcsec";
    found.parameters.push_back(amplitudeOf(weighed, 0, count, name));
  }
  found.probability = std::exp(weighed.logPosterior() - logSumOf(all));
  return found;
}

std::vector<Form> lookAlikesOfFirst(const FormSystem& system, const FormReadings& readings,
                                    const std::vector<WeighedForm>& all) {
  constexpr double alike = thresholds.hardlyDifferent;
  constexpr double nearly = alike * alike / 2;  // natural logarithm
  const WeighedForm& first = all.front();
  const auto trace = [&](const WeighedForm& one) -> VectorXd {
    return system.visible(formColumns(readings, one.form) * one.amplitudes);
  };
  const VectorXd own = trace(first);
  std::vector<Form> forms;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i].form.isFree() && !first.form.isFree()) continue;  // a free form contains any function
    const bool isLikely = first.logPosterior() - all[i].logPosterior() < nearly;
    const bool isAlike = !isLikely && all[i].amplitudes.size() > 0 &&
                         (trace(all[i]) - own).norm() < alike * std::sqrt(system.variance());
    if (isLikely || isAlike) forms.push_back(all[i].form);
  }
  if (first.form.carrier == FormCarrier::Slider && !readings.of(FormCarrier::Tangential).isZero()) {
    forms.push_back(first.form);
    forms.back().carrier = FormCarrier::Tangential;
  }
  return forms;
}

}  // namespace alidade
