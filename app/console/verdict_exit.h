#pragma once

#include <mutex>
#include <optional>

#include "core/diagnosis/decision.h"

namespace alidade::console {

/// The exit code for the verdicts of all sessions of a call: 3 if any is rejected, else 4 if any is undecided
/// or has no verdict, else 0 (accepted).
class VerdictExit {
 public:
  /// Counts the decision on one session; absent: the session has no verdict. Callable from any thread.
  void take(const std::optional<AcceptanceDecision>& decision);
  int code() const;

 private:
  mutable std::mutex m_guard;
  bool m_anyRejected = false, m_anyUndecided = false;
};

}  // namespace alidade::console
