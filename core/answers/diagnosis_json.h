#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// One JSON document: lengths in mm, angles in arcseconds, parameters in the units of the catalogue, null for
/// what is no number. `session` names it, `findings` were made beforehand.
std::string diagnosisJson(const std::string& session, const Diagnosis& diagnosis,
                          const std::vector<Finding>& findings);
/// The document itself, and that of a cause.
nlohmann::ordered_json diagnosisDocument(const std::string& session, const Diagnosis& diagnosis,
                                         const std::vector<Finding>& findings);
nlohmann::ordered_json causeDocument(const Cause& cause);

}  // namespace alidade
