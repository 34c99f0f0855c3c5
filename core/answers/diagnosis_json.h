#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// Returns one JSON document. Lengths are in mm, angles in arcseconds, parameters in the units of the
/// catalogue; numbers that are not finite are null. `session` is the session's name; `findings` come from
/// `findingsBeforehand`; `digest` is the SHA-256 of its file, or empty.
std::string diagnosisJson(const std::string& session, const Diagnosis& diagnosis,
                          const std::vector<Finding>& findings, const std::string& digest = {});
/// Returns the document as an object, and the object of a cause.
nlohmann::ordered_json diagnosisDocument(const std::string& session, const Diagnosis& diagnosis,
                                         const std::vector<Finding>& findings);
nlohmann::ordered_json causeDocument(const Cause& cause);

}  // namespace alidade
