#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade::console {

/// The diagnosis and the preceding findings as text for a terminal. `session` names it.
std::string diagnosisText(const std::string& session, const Diagnosis& diagnosis,
                          const std::vector<Finding>& findings);

}  // namespace alidade::console
