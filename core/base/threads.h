#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace alidade {

/// Does `work` in `threads` ≥ 1 threads at once, this one among them, and comes back when all of them are
/// done. What the first of them throws is thrown here; the others go on to their end.
void inThreads(std::size_t threads, const std::function<void()>& work);

/// Does `work` for each number below `count`, in `threads` ≥ 1 threads at once, and comes back when all are
/// done; in one thread, one after the other. What the first of them throws is thrown here.
void doEach(std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& work);
/// The same for each of `pieces`.
void doAll(std::size_t threads, const std::vector<std::function<void()>>& pieces);

/// In how many threads to do what passes over so many rows: below some thousands, a thread of its own costs
/// more than it saves.
std::size_t threadsFor(std::size_t rows);

}  // namespace alidade
