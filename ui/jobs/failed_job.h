#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string>

#include "core/session/session.h"

namespace alidade::ui {

/// Work that broke down, with what is needed to find out why.
struct FailedJob {
  std::string job;                         ///< as in "The … failed", in the context `Job`
  std::string reason;                      ///< as `thrownReason` has it
  std::optional<Session> session = {};     ///< as typed; absent where the work had none
  std::optional<std::uint64_t> seed = {};  ///< of random draws
};

/// Where records of failures are: `problems` in the folder of the program's data.
QString problemsFolder();

/// Writes a record, one of a job and reason as long as the program runs and the newest 50 in all, and answers
/// with the sentences for the user: what failed, why, that nothing typed is lost, and where the record is.
/// Never throws.
std::string tellFailure(const FailedJob& failed);

}  // namespace alidade::ui
