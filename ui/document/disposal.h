#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "core/base/sole_holder.h"

namespace alidade::ui {

/// Runs `work` on another thread if called on the window's thread, otherwise at once.
void doAside(std::function<void()> work);

/// A shared value that may be large: the last owner, if in the window's thread, does not wait for its
/// destruction.
template <typename Value>
std::shared_ptr<const Value> sharedAside(Value value) {
  return std::shared_ptr<const Value>(new Value(std::move(value)),
                                      [](const Value* old) { doAside([old] { delete old; }); });
}

/// The value itself if nobody else owns it; else absent, and the owners keep it. Only for values of
/// `sharedAside`, which are not const.
template <typename Value>
std::unique_ptr<Value> takenBack(std::shared_ptr<const Value> shared) {
  if (!isSoleHolder(shared)) return nullptr;
  return std::make_unique<Value>(std::move(const_cast<Value&>(*shared)));
}

}  // namespace alidade::ui
