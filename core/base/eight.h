#pragma once

#include <cstddef>

namespace alidade {

// Eight numbers at once: one wide register of the processor, or two or four narrower ones.

inline constexpr std::size_t eight = 8;

using Eight = double __attribute__((vector_size(eight * sizeof(double))));

/// Aligned in memory for any clone of a function.
struct alignas(sizeof(Eight)) EightKept {
  Eight at;
};

// A function with this prefix is compiled for several kinds of processor. The choice is made at load time,
// before the thread sanitizer can observe it.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define ALIDADE_WIDE __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define ALIDADE_WIDE
#endif

}  // namespace alidade
