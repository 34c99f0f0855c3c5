#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/certificate/certificate_source.h"
#include "core/certificate/element.h"

namespace alidade {

/// A document for people, embedded in a certificate.
struct CertificateDocument {
  std::string fileName, mimeType;
  std::string_view bytes;
};

struct CertificateOptions {
  std::string version;          ///< of this program
  std::string measuredOn = {};  ///< a day, used if the session states none
  std::string country = {};     ///< of the laboratory, ISO 3166-1: "DE"; empty: not stated
  std::string performedAt =
      {};  ///< "laboratory", "customer", "laboratoryBranch", "customerBranch" or "other"
  std::string manufacturer = {};  ///< of the device; empty: not stated
  std::string issued = {};        ///< day of issue; empty: not stated
  bool isDraft = false;           ///< a missing entry is “not stated” instead of an error
  std::vector<CertificateLanguage> languages = {};  ///< the binding language first; empty: English
  std::optional<CertificateDocument> report = {};   ///< the acceptance report, as PDF
};

struct CalibrationCertificate {
  std::string xml;
  /// Nouns for `Phrase::of`: the required entries that are empty. A draft states them as “not stated”.
  std::vector<const char*> notStated;
};

/// The digital calibration certificate of a session (PTB, DCC 3.2.0, values by D-SI 2.1.0), UTF-8. It states
/// the parties and the device; Δd, measured and fit only, with U, k and coverage; Δz, O1, O2 and the radii;
/// the conditions, the instrument and the decision rule with the statement of conformity (`conformityOf`). It
/// embeds the session's file, the results of `alidade-cli fit --json` and the report. The same source and
/// options give the same bytes: the clock is not used, and without a report number the identifier is derived
/// from the session's SHA-256.
///
/// Fails without the day of the measurement, which the schema requires, and on an invalid day, country or
/// place of performance. If `isDraft` is false, it also fails without an entry that ISO/IEC 17025, 7.8.2, or
/// the schema requires.
Result<CalibrationCertificate> calibrationCertificate(const CertificateSource& source,
                                                      const CertificateOptions& options);

}  // namespace alidade
