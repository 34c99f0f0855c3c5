#pragma once

#include <cstddef>

namespace alidade {

// Arithmetic on eight numbers at once, in one wide register of the processor or in two or four narrower ones.

inline constexpr std::size_t eight = 8;

using Eight = double __attribute__((vector_size(eight * sizeof(double))));

/// Eight numbers in memory, aligned for every compiled version of a function.
struct alignas(sizeof(Eight)) EightKept {
  Eight at;
};

// A function with this prefix is compiled for several kinds of processor. The version is chosen at load time,
// which the thread sanitizer does not support.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define ALIDADE_WIDE __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define ALIDADE_WIDE
#endif

}  // namespace alidade
