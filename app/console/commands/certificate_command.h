#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/signature/signature.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli certificate` was asked.
struct CertificateRequest {
  std::string file;                                ///< `-`: standard input
  std::string out;                                 ///< the certificate's path
  std::string pdf;                                 ///< of the acceptance report to go with it; empty: none
  std::string measuredOn;                          ///< where the session states no day
  std::string country, performedAt, manufacturer;  ///< as `CertificateOptions` has them
  std::string issued;                              ///< day of issue; empty: none
  std::string instrument;                          ///< path of an instrument record; empty: none
  SigningFiles signing = {};
};

struct CertificateAnswer {
  std::string result;
  std::vector<std::string> remarks;
};

/// Adds `certificate FILE --out OUT.xml [--pdf REPORT.pdf] …`, which fills in `request`.
void addCertificateCommand(CLI::App& app, CertificateRequest& request);

/// Writes the digital calibration certificate of a session, signed where asked for.
Result<CertificateAnswer> runCertificate(const CertificateRequest& request);

}  // namespace alidade::console
