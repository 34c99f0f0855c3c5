#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/diagnosis/forms/found_form.h"

namespace alidade {

struct FoundForms {
  std::vector<FoundForm> forms;
  std::vector<FormFamily> families;  ///< family of each form
  /// For each form: the form itself and nearly as likely ones in its place, the likeliest first.
  std::vector<std::vector<WeighedForm>> likely;
  int numbers = 0;  ///< amplitudes and shape numbers of all forms
  /// Error of each reading's prediction from other readings (`addShrinkage`), in σ of the reading; empty if
  /// none is predicted.
  Eigen::VectorXd heldOutErrors = {};
};

/// Decisions that depend on where the readings come from.
struct FormChoice {
  std::function<bool(const std::vector<WeighedForm>&)> isNamed;  ///< whether the first form is named
  std::function<bool(int numbers)> isAnythingLeft;               ///< whether a gap is left by so many numbers
  std::function<void(const WeighedForm&, FoundForm&)> note;      ///< completes a named form
};

/// Finds up to three forms, one after the other. `system` absorbs each form before the next search.
FoundForms findForms(FormSystem& system, const FormReadings& readings,
                     const std::vector<FormFamily>& families, const FormChoice& choice,
                     const std::stop_token& stop);

/// Whether the odds of all forms together against no form reach 20 : 1, and the first form has amplitudes.
/// The prior odds are those of a pattern.
bool beatNothing(const std::vector<WeighedForm>& all);

}  // namespace alidade
