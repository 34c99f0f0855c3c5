#pragma once

#include <QDateTime>
#include <QString>
#include <optional>

#include "core/signature/signature.h"
#include "ui/report/certificate.h"

namespace alidade {

/// What `alidade` writes without a window.
struct ReportCommand {
  QString path;                         ///< of the session
  QString report;                       ///< where the acceptance report goes; empty: none is asked for
  QString certificate;                  ///< where the certificate goes, likewise
  ui::CertificateEntries entries = {};  ///< of the certificate
  SigningFiles signing = {};            ///< no key: unsigned
};

/// `alidade --report` and `alidade --certificate`: writes the report or the certificate of a session, of the
/// day that the environment's SOURCE_DATE_EPOCH names, else of today. Answers with the exit code: 0; 2 and
/// one line on stderr where the session, the key or the place of the file is no good; 1 and one line where it
/// fails.
int writeReport(const ReportCommand& command);

}  // namespace alidade
