#pragma once

#include <vector>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

// The lists of causes in the result.

/// A cause for each part of the answer's explanation; all gross errors together are one cause.
std::vector<Cause> causesOf(const Inquiry& inquiry, const Answer& answer);

/// The verdict of an answer with these causes.
DiagnosisVerdict verdictOf(const Answer& answer, const std::vector<Cause>& causes);

/// Every effect and every other single cause found, ranked by how well each alone explains the leftover.
std::vector<Candidate> candidatesOf(const Inquiry& inquiry);

}  // namespace alidade
