#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/diagnosis/conclusion/answer.h"
#include "core/diagnosis/forms/find_forms.h"

namespace alidade {

/// Replaces the answer's pattern (`Unknown`) or effects (`Several`) by forms. The answer becomes
/// `Unknown`; its models are fitted to the readings minus the likeliest forms. Explanations with a pattern
/// become explanations with the forms, or with one form replaced by a nearly as likely one. Nothing changes
/// without forms, or if these readings determine no model.
void takeUpForms(Inquiry& inquiry, Answer& answer, const FoundForms& found);

/// Whether the pattern of the answer consists of forms.
bool hasForms(const Inquiry& inquiry, const Answer& answer);

/// Δd with forms: the average over the explanations with forms, linearised at the inquiry's base.
std::optional<IntersectionEstimate> intersectionWithForms(const Inquiry& inquiry, const Answer& answer);

/// The measurement minus a pattern. `taken` is the contribution of the pattern to each reading of the
/// inquiry's leftover, σ. Rows are also corrected for the displacement of a zero that is not among the
/// sightings.
Measurement withoutPattern(Measurement measurement, const Inquiry& inquiry, const Eigen::VectorXd& taken);

}  // namespace alidade
