#include "tests/ui/failing_memory.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/support/guarded_memory.h"

namespace {

std::atomic<bool> isScarce = false;
thread_local bool isSpared = false;

}  // namespace

#ifndef ALIDADE_MEMORY_IS_GUARDED

void* operator new(std::size_t size) {
  constexpr std::size_t large = 256;
  if (size >= large && isScarce && !isSpared) throw std::bad_alloc();
  for (;;) {
    if (void* block = std::malloc(size > 0 ? size : 1)) return block;
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}

#endif

namespace alidade::ui {

FailingMemory::FailingMemory() {
  isSpared = true;
  isScarce = true;
}

FailingMemory::~FailingMemory() {
  isScarce = false;
  isSpared = false;
}

bool FailingMemory::isPossible() {
#ifdef ALIDADE_MEMORY_IS_GUARDED
  return false;
#else
  return true;
#endif
}

}  // namespace alidade::ui
