#pragma once

#include <functional>
#include <memory>
#include <utility>

namespace alidade::ui {

/// Does `work` on another thread where this is the window's, otherwise at once.
void doAside(std::function<void()> work);

/// A value that may be large: an owner in the window's thread that lets go of it last does not wait until all
/// of it is freed.
template <typename Value>
std::shared_ptr<const Value> sharedAside(Value value) {
  return std::shared_ptr<const Value>(new Value(std::move(value)),
                                      [](const Value* old) { doAside([old] { delete old; }); });
}

}  // namespace alidade::ui
