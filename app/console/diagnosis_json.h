#pragma once

#include <string>

#include "core/diagnosis/diagnosis.h"

namespace alidade::console {

/// One JSON document: lengths in mm, angles in arcseconds, parameters in the units of the catalogue.
/// `session` names it.
std::string diagnosisJson(const std::string& session, const Diagnosis& diagnosis);

}  // namespace alidade::console
