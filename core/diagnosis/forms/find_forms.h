#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/diagnosis/forms/found_form.h"

namespace alidade {

/// The conventions of naming a form, each with its reason.
struct FormThresholds {
  /// All forms together against no form: none is named in 600 simulated sessions without an effect.
  double odds = 20;
  /// Another form is sought if the p-value of the leftover against noise alone is below this limit: no more
  /// forms are reported than are needed to leave only noise.
  double noiseAlone = 0.2;
  std::size_t mostForms = 3;  ///< the readings of a session hardly determine more
  /// A form that leaves only noise is reported even if the patterns are likelier by up to these odds: some
  /// patterns resemble the form.
  double nearlyAsLikely = 20;
  double ofPatterns = 0.05;      ///< prior of all patterns against a form: they serve gaps without a form
  std::size_t mostPatterns = 4;  ///< the others add less than these to the sum
  double significant = 0.05;     ///< p-value of the F test on held-out readings
  double averagedWithin = 4;     ///< natural logarithm of the odds: less likely forms are not averaged
  std::size_t mostAveraged = 6;
};

inline constexpr FormThresholds formThresholds;

struct FoundForms {
  std::vector<FoundForm> forms;
  std::vector<FormFamily> families;  ///< family of each form
  /// For each form: the form itself and nearly as likely forms in its place, the likeliest first.
  std::vector<std::vector<WeighedForm>> likely;
  int numbers = 0;  ///< amplitudes and shape numbers of all forms
  /// Error of each reading's prediction from other readings (`addShrinkage`), in σ of the reading; empty if
  /// none is predicted.
  Eigen::VectorXd heldOutErrors = {};
};

/// Decisions that depend on where the readings come from.
struct FormChoice {
  std::function<bool(const std::vector<WeighedForm>&)> isNamed;  ///< whether the likeliest form is reported
  std::function<bool(int numbers)> isAnythingLeft;               ///< whether so many numbers leave a gap
  std::function<void(const WeighedForm&, FoundForm&)> note;      ///< completes a reported form
};

/// Finds up to three forms, one after the other. `system` absorbs each form before the next search.
FoundForms findForms(FormSystem& system, const FormReadings& readings,
                     const std::vector<FormFamily>& families, const FormChoice& choice,
                     const std::stop_token& stop);

/// Whether the odds of all forms together against no form reach `FormThresholds::odds`, and the first form
/// has amplitudes. The prior odds are those of a pattern.
bool beatNothing(const std::vector<WeighedForm>& all);

/// Fills `FoundForm::trace` of each form. `left` has the residuals in σ with all forms in the model.
/// `leftover` and `measurement` belong to the same model without the forms.
///
/// A sighting has several readings i with residuals rᵢ. Their derivatives by the carrier, after elimination
/// of the arc angle, are cᵢ. The sighting gives f(x) + Σ cᵢrᵢ/Σ cᵢ² as the form's value (partial residual).
/// Source: Larsen and McCleary, "The use of partial residual plots", Technometrics 14 (1972).
void addTraces(FoundForms& found, const Eigen::VectorXd& left, const Leftover& leftover,
               const Measurement& measurement, const FormReadings& readings);

/// Fills `FoundForm::cleanRange`.
void addCleanRange(FoundForm& found, const FormReadings& readings);

}  // namespace alidade
