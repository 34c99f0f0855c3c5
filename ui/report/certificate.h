#pragma once

#include <QString>
#include <QStringList>
#include <string>

#include "core/base/result.h"
#include "ui/report/acceptance_report.h"

namespace alidade::ui {

/// What a certificate states beside the session; empty: not stated.
struct CertificateEntries {
  QString measuredOn;    ///< where the session states no day
  QString country;       ///< of the laboratory, ISO 3166-1
  QString performedAt;   ///< "laboratory", "customer", …
  QString manufacturer;  ///< of the device
};

struct WrittenCertificate {
  std::string xml;
  QStringList notStated;  ///< what its schema asks for and is left empty, as nouns
};

/// The digital calibration certificate (`calibrationCertificate`) of an evaluation, `report.gap` its gap,
/// issued on the day of the report; texts in English, and in the language of the report where that is
/// another. `pdf`: the report that goes with it, called `pdfName`; empty: none.
Result<WrittenCertificate> certificateOf(const ReportSource& source, const ReportOptions& report,
                                         const CertificateEntries& entries, const std::string& pdf = {},
                                         const QString& pdfName = {});

/// Writes it with the report rendered and embedded, signed where there is a signer. Answers with what is not
/// stated.
Result<QStringList> writeCertificate(const ReportSource& source, const QString& outPath,
                                     const ReportOptions& report, const CertificateEntries& entries);

}  // namespace alidade::ui
