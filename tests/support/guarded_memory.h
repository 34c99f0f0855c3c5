#pragma once

// Defined if a sanitizer watches every access: it occupies the address space, replaces `new`, and multiplies
// memory and time, so limits on these are meaningless.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ALIDADE_MEMORY_IS_GUARDED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ALIDADE_MEMORY_IS_GUARDED
#endif
#endif

namespace alidade::test {

/// Returns how many of `wanted` cases to run: under a sanitizer each takes ten times as long.
constexpr int inTheTime(int wanted) {
#ifdef ALIDADE_MEMORY_IS_GUARDED
  return (wanted + 9) / 10;
#else
  return wanted;
#endif
}

}  // namespace alidade::test
