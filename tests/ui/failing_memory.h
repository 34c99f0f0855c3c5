#pragma once

namespace alidade::ui {

/// While such an object exists, `new` of 256 bytes or more fails in all threads except its own. Small blocks
/// succeed, as when real memory runs short.
class FailingMemory {
 public:
  FailingMemory();
  ~FailingMemory();
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;

  /// False under a sanitizer, whose own `new` must not be replaced.
  static bool isPossible();
};

}  // namespace alidade::ui
