#pragma once

#include "core/base/result.h"
#include "core/certificate/calibration_certificate.h"
#include "core/certificate/stated.h"

namespace alidade {

/// The entries for a certificate. Fails without the day of the measurement, or on an invalid day, country or
/// place of performance.
Result<StatedEntries> statedEntries(const CertificateSource& source, const CertificateOptions& options);

/// Adds the `administrativeData`. `languages`: those of the certificate.
void addAdministrativeData(const Element& certificate, const CertificateSource& source,
                           const CertificateOptions& options,
                           const std::vector<CertificateLanguage>& languages, const StatedEntries& stated);

/// Adds the element `list` with this program as its only software.
void addSoftware(const Element& to, const char* list, const std::string& version);

}  // namespace alidade
