#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/diagnosis/forms/found_form.h"

namespace alidade {

struct FoundForms {
  std::vector<FoundForm> forms;
  std::vector<FormFamily> families;  ///< of each form
  /// Of each form: itself, and those in its place that are nearly as likely, the likeliest first.
  std::vector<std::vector<WeighedForm>> likely;
  int numbers = 0;  ///< amplitudes and shape numbers of all forms
  /// Of each reading as `addShrinkage` predicts it from others, in its σ; empty where none is predicted.
  Eigen::VectorXd heldOutErrors = {};
};

/// What the readings at hand decide.
struct FormChoice {
  std::function<bool(const std::vector<WeighedForm>&)> isNamed;  ///< the first of all
  std::function<bool(int numbers)> isAnythingLeft;               ///< after forms of so many numbers
  std::function<void(const WeighedForm&, FoundForm&)> note;      ///< completes a form that is named
};

/// One form after the other, up to three, each beside those before it, which `system` then takes up.
FoundForms findForms(FormSystem& system, const FormReadings& readings,
                     const std::vector<FormFamily>& families, const FormChoice& choice,
                     const std::stop_token& stop);

/// Together by 20 : 1, at the odds of any pattern, and the first has amplitudes.
bool beatNothing(const std::vector<WeighedForm>& all);

}  // namespace alidade
