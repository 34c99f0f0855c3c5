#pragma once

#include <string>

#include "core/diagnosis/diagnosis.h"

namespace alidade::console {

/// The diagnosis for reading on a terminal. `session` names it.
std::string diagnosisText(const std::string& session, const Diagnosis& diagnosis);

}  // namespace alidade::console
