#pragma once

#include <functional>
#include <memory>
#include <utility>

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

}  // namespace alidade::ui
