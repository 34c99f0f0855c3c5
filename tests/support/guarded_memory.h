#pragma once

// Defined where a sanitizer watches every access: it takes the address space for itself, brings its own
// `new`, and multiplies what is used of memory and time, so limits on these mean nothing.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ALIDADE_MEMORY_IS_GUARDED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ALIDADE_MEMORY_IS_GUARDED
#endif
#endif

namespace alidade::test {

/// How many of `wanted` cases are run: under a sanitizer each takes ten times as long.
constexpr int inTheTime(int wanted) {
#ifdef ALIDADE_MEMORY_IS_GUARDED
  return (wanted + 9) / 10;
#else
  return wanted;
#endif
}

}  // namespace alidade::test
