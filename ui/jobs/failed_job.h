#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string>

#include "core/session/session.h"

namespace alidade::ui {

/// Failed work, with the data needed to find the reason.
struct FailedJob {
  std::string job;                         ///< as in "The … failed", in the context `Job`
  std::string reason;                      ///< text of `thrownReason`
  std::optional<Session> session = {};     ///< as typed; absent if the work had none
  std::optional<std::uint64_t> seed = {};  ///< seed of random draws
};

/// The folder of failure records: `problems` in the program's data folder.
QString problemsFolder();

/// Writes a record: one per job and reason while the program runs, the newest 50 in all. Returns sentences
/// for the user: what failed, why, that nothing typed is lost, and the record's path. Never throws.
std::string tellFailure(const FailedJob& failed);

}  // namespace alidade::ui
