#pragma once

#include <memory>

namespace alidade {

/// Is `shared` the only owner, so that its value may be changed? If so, the accesses of all former owners in
/// other threads are complete.
template <typename Value>
bool isSoleHolder(const std::shared_ptr<Value>& shared) {
  if (shared.use_count() != 1) return false;
  std::shared_ptr<Value>(shared).reset();  // reading the count does not synchronise; releasing a copy does
  return true;
}

}  // namespace alidade
