#pragma once

#include "core/base/problem.h"
#include "core/diagnosis/result/diagnosis_fault.h"

namespace alidade {

/// Returns the reason for a missing diagnosis as a sentence, with its place in the session.
Problem problemOf(const NoModel& fault);
Problem problemOf(const DiagnosisFault& fault);

}  // namespace alidade
