#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace alidade {

/// Runs `work` once in each of `threads` ≥ 1 threads, including the calling one, and returns when all are
/// done. The first exception is rethrown in the calling thread; the other threads complete.
void inThreads(std::size_t threads, const std::function<void()>& work);

/// Runs `work` for each number below `count`, in `threads` ≥ 1 threads, and returns when all are done. A
/// single thread takes them in order. The first exception is rethrown in the calling thread.
void doEach(std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& work);
/// Runs all `pieces`, in threads as `doEach` does.
void doAll(std::size_t threads, const std::vector<std::function<void()>>& pieces);

/// `wanted`, or as many threads as the machine has if it is 0.
std::size_t threadsOrAll(std::size_t wanted);

/// The number of threads for work on this many rows: below some thousands, an additional thread costs more
/// than it saves.
std::size_t threadsFor(std::size_t rows);

}  // namespace alidade
