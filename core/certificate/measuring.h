#pragma once

#include <string>

#include "core/certificate/certificate_source.h"
#include "core/certificate/element.h"

namespace alidade {

/// Adds the methods, software, the theodolite with its certificate, and the conditions, in the order of the
/// schema.
void addMeasuring(const Element& result, const CertificateSource& source, const std::string& version);

}  // namespace alidade
