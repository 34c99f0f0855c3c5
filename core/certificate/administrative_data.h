#pragma once

#include "core/base/result.h"
#include "core/certificate/calibration_certificate.h"
#include "core/certificate/stated.h"

namespace alidade {

/// The session's statements for a certificate; fails as `calibrationCertificate` does.
Result<StatedEntries> statedEntries(const CertificateSource& source, const CertificateOptions& options);

/// Adds the `administrativeData`. `languages`: those of the certificate.
void addAdministrativeData(const Element& certificate, const CertificateSource& source,
                           const CertificateOptions& options,
                           const std::vector<CertificateLanguage>& languages, const StatedEntries& stated);

/// Adds this program to a list of software.
void addSoftware(const Element& to, const char* list, const std::string& version);

}  // namespace alidade
