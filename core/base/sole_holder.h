#pragma once

#include <memory>

namespace alidade {

/// Is this the only owner, so that the value may be changed? Accesses of other threads before they released
/// it are then complete.
template <typename Value>
bool isSoleHolder(const std::shared_ptr<Value>& shared) {
  if (shared.use_count() != 1) return false;
  std::shared_ptr<Value>(shared).reset();  // reading a count does not synchronise; releasing one does
  return true;
}

}  // namespace alidade
