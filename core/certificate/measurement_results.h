#pragma once

#include <string>

#include "core/certificate/certificate_source.h"
#include "core/certificate/element.h"

namespace alidade {

/// Adds the `measurementResults`. `version`: of this program.
void addMeasurementResults(const Element& certificate, const CertificateSource& source,
                           const std::string& version);

}  // namespace alidade
