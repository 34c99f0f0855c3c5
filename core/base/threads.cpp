#include "core/base/threads.h"

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

}  // namespace alidade
