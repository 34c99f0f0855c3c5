#pragma once

#include <QString>
#include <QStringList>
#include <string>

#include "core/base/result.h"
#include "ui/report/acceptance_report.h"

namespace alidade::ui {

/// Statements of a certificate that the session lacks; empty: not stated.
struct CertificateEntries {
  QString measuredOn = {};    ///< used if the session states no day
  QString country = {};       ///< country of the laboratory, ISO 3166-1
  QString performedAt = {};   ///< "laboratory", "customer", …
  QString manufacturer = {};  ///< manufacturer of the device
  bool isDraft = false;       ///< true: required entries may be missing

  bool operator==(const CertificateEntries&) const = default;
};

struct WrittenCertificate {
  std::string xml;
  QStringList notStated;  ///< required by the schema but empty, as nouns
};

/// The digital calibration certificate (`calibrationCertificate`) of an evaluation with its gap `report.gap`,
/// issued on the report's date. Its texts are in English, and also in the report's language if that differs.
/// `pdf`: the accompanying report, named `pdfName`; empty: none.
Result<WrittenCertificate> certificateOf(const ReportSource& source, const ReportOptions& report,
                                         const CertificateEntries& entries, const std::string& pdf = {},
                                         const QString& pdfName = {});

/// Writes the certificate with the rendered report embedded, signed if there is a signer. Returns the missing
/// statements.
Result<QStringList> writeCertificate(const ReportSource& source, const QString& outPath,
                                     const ReportOptions& report, const CertificateEntries& entries);

}  // namespace alidade::ui
