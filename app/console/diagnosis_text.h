#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade::console {

/// The diagnosis and what was found beforehand for reading on a terminal. `session` names it.
std::string diagnosisText(const std::string& session, const Diagnosis& diagnosis,
                          const std::vector<Finding>& findings);

}  // namespace alidade::console
