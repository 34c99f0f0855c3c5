#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/diagnosis/conclusion/answer.h"
#include "core/diagnosis/forms/find_forms.h"

namespace alidade {

/// Replaces the pattern of an unknown cause, or many effects, by forms. Explanations with a pattern become
/// explanations with the forms, or with one form replaced by a nearly as likely one. The answer becomes an
/// Unknown, whose models have readings without the likeliest forms. Nothing changes without forms, or if the
/// readings do not determine such a model.
void takeUpForms(Inquiry& inquiry, Answer& answer, const FoundForms& found);

/// Whether the pattern of the answer consists of forms.
bool hasForms(const Inquiry& inquiry, const Answer& answer);

/// Δd afterwards with forms: the average over those in the inquiry, in the model linear at its base.
std::optional<IntersectionEstimate> intersectionWithForms(const Inquiry& inquiry, const Answer& answer);

/// The readings of the inquiry without a pattern. `taken`: what the pattern adds to each reading of the
/// inquiry's leftover, σ. If the zeros are not among the sightings, rows refer to zeros without the pattern.
Measurement withoutPattern(Measurement measurement, const Inquiry& inquiry, const Eigen::VectorXd& taken);

}  // namespace alidade
