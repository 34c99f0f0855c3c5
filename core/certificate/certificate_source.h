#pragma once

#include <string>
#include <string_view>

#include "core/answers/fit_answer.h"
#include "core/session/session.h"

namespace alidade {

/// What a certificate is made of. Must not outlive what it refers to.
struct CertificateSource {
  const Session& session;
  const FitAnswer& answer;  ///< of that session
  std::string fileName;     ///< of the session, without folder; empty: in no file
  std::string_view bytes;   ///< of its file, or as it would be saved
};

}  // namespace alidade
