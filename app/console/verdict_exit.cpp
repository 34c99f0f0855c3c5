#include "app/console/verdict_exit.h"

#include "app/console/channels.h"

namespace alidade::console {

void VerdictExit::take(const std::optional<AcceptanceDecision>& decision) {
  const Verdict verdict = decision ? decision->verdict : Verdict::Undecided;
  const std::scoped_lock lock(m_guard);
  m_anyRejected = m_anyRejected || verdict == Verdict::Reject;
  m_anyUndecided = m_anyUndecided || verdict == Verdict::Undecided;
}

int VerdictExit::code() const {
  const std::scoped_lock lock(m_guard);
  return m_anyRejected ? Rejected : m_anyUndecided ? Undecided : Done;
}

}  // namespace alidade::console
