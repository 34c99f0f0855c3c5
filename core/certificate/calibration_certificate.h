#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/certificate/certificate_source.h"
#include "core/certificate/element.h"

namespace alidade {

/// A document for people that goes with a certificate.
struct CertificateDocument {
  std::string fileName, mimeType;
  std::string_view bytes;
};

struct CertificateOptions {
  std::string version;          ///< of this program
  std::string measuredOn = {};  ///< a day, where the session states none
  std::string country = {};     ///< of the laboratory, ISO 3166-1: "DE"; empty: not stated, likewise below
  std::string performedAt =
      {};  ///< "laboratory", "customer", "laboratoryBranch", "customerBranch" or "other"
  std::string manufacturer = {};                    ///< of the device
  std::string issued = {};                          ///< day of issue; empty: none is stated
  std::vector<CertificateLanguage> languages = {};  ///< the binding one first; empty: English
  std::optional<CertificateDocument> report = {};   ///< the acceptance report, as PDF
};

struct CalibrationCertificate {
  std::string xml;
  /// What the schema requires and the session leaves empty, as nouns for `Phrase::of`: the certificate calls
  /// it not stated.
  std::vector<const char*> notStated;
};

/// The digital calibration certificate of a session (PTB, DCC 3.2.0, values by D-SI 2.1.0), UTF-8: who
/// measured what for whom, Δd as measured and of the fit alone with U, k and coverage, Δz, O1, O2, the radii,
/// the conditions, the instrument, the decision rule with the statement of conformity (`conformityOf`), and
/// within it the session's file, the results as `alidade-cli fit --json` has them, and the report. The same
/// source and options give the same bytes: no clock is asked, and without a number of the report the
/// identifier is made of the session's SHA-256.
///
/// Fails where the schema requires what nothing can stand for: the day of the measurement; and where a day,
/// the country or the place of performance is none.
Result<CalibrationCertificate> calibrationCertificate(const CertificateSource& source,
                                                      const CertificateOptions& options);

}  // namespace alidade
