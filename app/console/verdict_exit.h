#pragma once

#include <mutex>
#include <optional>

#include "core/diagnosis/decision.h"

namespace alidade::console {

/// The exit code of a call for the verdicts of its sessions, by the one that asks most for a person: 3 if any
/// is rejected, else 4 if any is undecided or has no verdict, else 0 (accepted).
class VerdictExit {
 public:
  /// The decision of one session, from any thread; absent: it has no verdict.
  void take(const std::optional<AcceptanceDecision>& decision);
  int code() const;

 private:
  mutable std::mutex m_guard;
  bool m_anyRejected = false, m_anyUndecided = false;
};

}  // namespace alidade::console
