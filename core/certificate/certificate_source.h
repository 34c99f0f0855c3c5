#pragma once

#include <string>
#include <string_view>

#include "core/answers/fit_answer.h"
#include "core/session/session.h"

namespace alidade {

/// The input of a certificate. Must not outlive the objects it refers to.
struct CertificateSource {
  const Session& session;
  const FitAnswer& answer;  ///< of that session
  std::string fileName;     ///< name of the session's file, without folder; empty: unsaved
  std::string_view bytes;   ///< bytes of the session's file, in the form in which it is saved
};

}  // namespace alidade
