#include "core/base/threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>

namespace alidade {
namespace {

TEST(Threads, WorkTogetherAndAreDoneAtTheEnd) {
  std::atomic<int> begun = 0, done = 0;
  inThreads(3, [&] {
    ++begun;
    while (begun < 3) std::this_thread::yield();  // none waits for another to end
    ++done;
  });
  EXPECT_EQ(done, 3);
}

TEST(Threads, ThrowHereWhatOneOfThemThrows) {
  const std::thread::id here = std::this_thread::get_id();
  std::atomic<int> done = 0;
  const auto work = [&] {
    if (std::this_thread::get_id() != here) throw std::runtime_error("in another thread");
    ++done;
  };
  EXPECT_THROW(inThreads(4, work), std::runtime_error);
  EXPECT_EQ(done, 1) << "the others came to their end";
}

TEST(Threads, AreThisOneWhereOneIsAskedFor) {
  std::set<std::thread::id> seen;
  inThreads(1, [&] { seen.insert(std::this_thread::get_id()); });
  EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

}  // namespace
}  // namespace alidade
