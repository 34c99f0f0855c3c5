#include "core/base/threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace alidade {

void inThreads(std::size_t threads, const std::function<void()>& work) {
  std::exception_ptr thrown;
  std::mutex keeping;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(keeping);
      if (!thrown) thrown = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < threads; ++i) others.emplace_back(guarded);
    guarded();
  }
  if (thrown) std::rethrow_exception(thrown);
}

void doEach(std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& work) {
  if (threads == 1) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<std::size_t> next = 0;
  inThreads(std::clamp<std::size_t>(count, 1, threads), [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  });
}

void doAll(std::size_t threads, const std::vector<std::function<void()>>& pieces) {
  doEach(threads, pieces.size(), [&](std::size_t i) { pieces[i](); });
}

std::size_t threadsOrAll(std::size_t wanted) {
  return wanted > 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
}

std::size_t threadsFor(std::size_t rows) {
  constexpr std::size_t many = 5'000, most = 4;
  return rows < many ? 1 : std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most);
}

}  // namespace alidade
