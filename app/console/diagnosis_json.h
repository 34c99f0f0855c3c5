#pragma once

#include <string>

#include "core/diagnosis/diagnosis.h"

namespace alidade::console {

/// One JSON document of the contract's keys: mm, arcseconds, catalogue units. `session` names it.
std::string diagnosisJson(const std::string& session, const Diagnosis& diagnosis);

}  // namespace alidade::console
