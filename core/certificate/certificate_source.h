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
  std::string fileName;     ///< of the session, without folder; empty: unsaved
  std::string_view bytes;   ///< of its file, or as they would be saved
};

}  // namespace alidade
