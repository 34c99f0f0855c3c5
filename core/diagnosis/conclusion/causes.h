#pragma once

#include <vector>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

// The lists of causes as they are handed out.

/// Every part of the answer's explanation; readings that are blamed together are one cause.
std::vector<Cause> causesOf(const Inquiry& inquiry, const Answer& answer);

/// What an answer with these causes comes to.
DiagnosisVerdict verdictOf(const Answer& answer, const std::vector<Cause>& causes);

/// Every effect by how well it explains the leftover alone, the best first.
std::vector<Candidate> candidatesOf(const Inquiry& inquiry);

}  // namespace alidade
