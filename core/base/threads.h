#pragma once

#include <cstddef>
#include <functional>

namespace alidade {

/// Does `work` in `threads` ≥ 1 threads at once, this one among them, and comes back when all of them are
/// done. What the first of them throws is thrown here; the others go on to their end.
void inThreads(std::size_t threads, const std::function<void()>& work);

}  // namespace alidade
