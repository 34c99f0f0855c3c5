#pragma once

#include <cstddef>

namespace alidade {

// Eight numbers at once: one register of a processor that has such wide ones, two or four of any other.

inline constexpr std::size_t eight = 8;

using Eight = double __attribute__((vector_size(eight * sizeof(double))));

/// In memory where any clone of a function wants them.
struct alignas(sizeof(Eight)) EightKept {
  Eight at;
};

// A function with this before it is compiled for several kinds of processor. Which of them serves is chosen
// before the thread sanitizer is there to watch the choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define ALIDADE_WIDE __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define ALIDADE_WIDE
#endif

}  // namespace alidade
