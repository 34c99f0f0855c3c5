#include "core/diagnosis/shared_form.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "core/diagnosis/forms/found_form.h"

namespace alidade {

namespace {

/// Factor from the numbers of `shapeOf` to `Form::numbers`: rad per degree for an angle, otherwise 1.
double unitOfShape(const Form& form) {
  return form.isOfAngle() ? std::numbers::pi / 180 : 1;
}

/// The numbers of the shape among the parameters.
std::span<const FormNumber> shapeOf(const FoundForm& found) {
  return std::span(found.parameters)
      .subspan(found.form.order > 0 ? 1 : 0, static_cast<std::size_t>(found.form.count()));
}

/// Whether every shape number has a finite standard uncertainty.
bool isDetermined(const FoundForm& found) {
  return std::ranges::all_of(shapeOf(found),
                             [](const FormNumber& number) { return std::isfinite(number.sigma); });
}

bool hasLookAlike(const FoundForm& found, const Form& form, double share) {
  return std::ranges::any_of(found.indistinguishableFrom, [&](const FormLookAlike& other) {
    if (!other.effect.empty() || !isOfOneKind(other.form, form)) return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(form.count()); ++i)
      if (std::abs(other.form.numbers[i] - form.numbers[i]) > share * std::abs(form.numbers[i])) return false;
    return true;
  });
}

/// Returns the weighted mean of the numbers that `in` selects, one from each form.
template <typename In>
FormNumber meanNumber(const std::vector<const FoundForm*>& forms, const In& in) {
  FormNumber mean = in(*forms.front());
  double weights = 0, sum = 0, square = 0;
  for (const FoundForm* form : forms) {
    const FormNumber& number = in(*form);
    const double weight = std::pow(number.sigma, -2);
    if (!std::isfinite(weight)) return mean;
    weights += weight;
    sum += weight * number.value;
  }
  if (!(weights > 0)) return mean;
  mean.value = sum / weights;
  for (const FoundForm* form : forms) square += std::pow((in(*form).value - mean.value) / in(*form).sigma, 2);
  const double freedom = std::max(static_cast<double>(forms.size()) - 1, 1.0);
  mean.sigma = std::sqrt(std::max(square / freedom, 1.0) / weights);
  return mean;
}

}  // namespace

bool isOfOneKind(const Form& a, const Form& b) {
  return a.isOfKind(b) && a.order == b.order;
}

bool agrees(const FoundForm& form, const FoundForm& other) {
  constexpr double mostSigmas = 3, ofGrid = 0.2;
  if (!isDetermined(form)) return false;
  if (isOfOneKind(form.form, other.form) && isDetermined(other)) {
    const auto isNear = [](const FormNumber& a, const FormNumber& b) {
      return std::abs(a.value - b.value) <= mostSigmas * std::hypot(a.sigma, b.sigma);
    };
    if (std::ranges::equal(shapeOf(form), shapeOf(other), isNear)) return true;
  }
  return hasLookAlike(other, form.form, ofGrid);
}

FoundForm meanOf(const std::vector<const FoundForm*>& forms) {
  FoundForm mean = *forms.front();
  for (std::size_t i = 0; i < mean.coefficients.size(); ++i)
    mean.coefficients[i] =
        meanNumber(forms, [i](const FoundForm& form) -> const FormNumber& { return form.coefficients[i]; });
  for (std::size_t i = mean.form.order > 0 ? 1 : 0; i < mean.parameters.size(); ++i)  // an order has no mean
    mean.parameters[i] =
        meanNumber(forms, [i](const FoundForm& form) -> const FormNumber& { return form.parameters[i]; });
  for (std::size_t i = 0; i < shapeOf(mean).size(); ++i)
    mean.form.numbers[i] = shapeOf(mean)[i].value * unitOfShape(mean.form);
  mean.formula = formulaOf(mean.form);
  for (const FoundForm* form : forms) {
    mean.probability = std::min(mean.probability, form->probability);
    std::erase_if(mean.indistinguishableFrom, [form](const FormLookAlike& other) {
      return std::ranges::none_of(form->indistinguishableFrom, [&](const FormLookAlike& its) {
        return its.effect == other.effect && (!its.effect.empty() || isOfOneKind(its.form, other.form));
      });
    });
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  mean.shrink = {.inSample = none, .heldOut = none, .f = none, .p = none};
  mean.trace = {};
  return mean;
}

}  // namespace alidade
