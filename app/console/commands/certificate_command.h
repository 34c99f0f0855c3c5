#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/signature/signature.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli certificate`.
struct CertificateRequest {
  std::string file;        ///< `-`: standard input
  std::string out;         ///< the certificate's path
  std::string pdf;         ///< path of the accompanying acceptance report; empty: none
  bool isDraft = false;    ///< whether to write the certificate although entries are missing
  std::string measuredOn;  ///< used if the session states no day
  std::string country, performedAt, manufacturer;  ///< as in `CertificateOptions`
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

/// Writes the digital calibration certificate of a session, signed on request.
Result<CertificateAnswer> runCertificate(const CertificateRequest& request);

}  // namespace alidade::console
