#pragma once

#include <QDateTime>
#include <QString>
#include <optional>

#include "core/signature/signature.h"
#include "ui/report/certificate.h"

namespace alidade {

/// The output of `alidade` without a window.
struct ReportCommand {
  QString path;                         ///< path of the session
  QString report;                       ///< path of the acceptance report; empty: not requested
  QString certificate;                  ///< path of the certificate; empty: not requested
  ui::CertificateEntries entries = {};  ///< entries of the certificate
  SigningFiles signing = {};            ///< no key: unsigned
};

/// `alidade --report` and `alidade --certificate`: writes the report or the certificate of a session, dated
/// by the environment's SOURCE_DATE_EPOCH, else today. Returns the exit code: 0; 2 and one line on stderr if
/// the session, the key or the output path is invalid; 1 and one line if it fails.
int writeReport(const ReportCommand& command);

}  // namespace alidade
