#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/failure.h"
#include "core/session/session.h"

namespace alidade::ui {

/// Failed work, with the data needed to find the reason.
struct FailedJob {
  std::string job;                         ///< a phrase, as in "The … failed"
  std::string reason;                      ///< text of `thrownReason`
  std::optional<Session> session = {};     ///< as typed; absent if the work had none
  std::optional<std::uint64_t> seed = {};  ///< seed of random draws
};

/// The folder of failure records: `problems` in the program's data folder.
QString problemsFolder();

/// Writes one record per job and reason while the program runs, and keeps the newest 50. Never throws.
FailedWork recorded(const FailedJob& failed);
/// Writes a record as `recorded` does, and returns sentences for the user. Never throws.
std::string reportFailure(const FailedJob& failed);

}  // namespace alidade::ui
