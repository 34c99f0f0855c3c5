#pragma once

namespace alidade::ui {

/// As long as it lives, `new` of 256 bytes and more fails in every thread but the one it was made in. Small
/// blocks are still there, as they are when real memory runs short.
class FailingMemory {
 public:
  FailingMemory();
  ~FailingMemory();
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;

  /// Not under a sanitizer, whose own `new` must not be replaced.
  static bool isPossible();
};

}  // namespace alidade::ui
