#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "core/base/sole_holder.h"

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

/// Has what is freed kept for what comes next: an evaluation of 10⁵ rows takes a sixth longer where its pages
/// go back to the system and are taken anew each time. Once, at the start of the program.
void keepFreedMemory();

/// The value itself, where nobody else holds it any more; else nothing, and it stays with them. Only of what
/// `sharedAside` made, which is no constant.
template <typename Value>
std::unique_ptr<Value> takenBack(std::shared_ptr<const Value> shared) {
  if (!isSoleHolder(shared)) return nullptr;
  return std::make_unique<Value>(std::move(const_cast<Value&>(*shared)));
}

}  // namespace alidade::ui
