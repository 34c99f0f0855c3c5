#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/diagnosis/conclusion/answer.h"
#include "core/diagnosis/forms/find_forms.h"

namespace alidade {

/// Puts forms into the place of an unknown's pattern, or of many effects: the inquiry's explanations with a
/// pattern become those with the forms, and with whatever is nearly as likely in the place of each. The
/// answer is then an unknown, its models of readings without the likeliest of them. Without forms, or where
/// the readings do not determine such a model, nothing changes.
void takeUpForms(Inquiry& inquiry, Answer& answer, const FoundForms& found);

/// Does the answer hold forms?
bool hasForms(const Inquiry& inquiry, const Answer& answer);

/// Δd afterwards with forms, averaged over those in the inquiry, in the model linear at its base.
std::optional<IntersectionEstimate> intersectionWithForms(const Inquiry& inquiry, const Answer& answer);

/// What the readings of the inquiry would be without a pattern. `taken`: σ of each reading of its leftover.
/// Where the zeros are not among the sightings, the rows count from zeros without it.
Measurement withoutPattern(Measurement measurement, const Inquiry& inquiry, const Eigen::VectorXd& taken);

}  // namespace alidade
