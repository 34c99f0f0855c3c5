#pragma once

#include <memory>

namespace alidade {

/// Does nobody else hold on to it any more, so that it may be changed? What other threads did with it before
/// they let go has then happened.
template <typename Value>
bool isSoleHolder(const std::shared_ptr<Value>& shared) {
  if (shared.use_count() != 1) return false;
  std::shared_ptr<Value>(shared).reset();  // a count that is only read orders nothing: one given back does
  return true;
}

}  // namespace alidade
