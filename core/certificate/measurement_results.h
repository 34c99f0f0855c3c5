#pragma once

#include <string>

#include "core/certificate/certificate_source.h"
#include "core/certificate/element.h"

namespace alidade {

/// Adds the `measurementResults`. `version`: of this program; `results`: `fitJson` of the answer.
void addMeasurementResults(const Element& certificate, const CertificateSource& source,
                           const std::string& version, const std::string& results);

}  // namespace alidade
