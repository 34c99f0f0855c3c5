#include "core/base/threads.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <functional>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

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

TEST(Threads, DoEveryPieceOnce) {
  for (const std::size_t threads : {1, 2, 9}) {
    std::array<std::atomic<int>, 5> done{};
    std::vector<std::function<void()>> pieces;
    for (std::atomic<int>& one : done) pieces.emplace_back([&one] { ++one; });
    doAll(threads, pieces);
    for (const std::atomic<int>& one : done) EXPECT_EQ(one, 1);
  }
  EXPECT_NO_THROW(doAll(3, {}));
}

TEST(Threads, DoPiecesInTheirOrderWhereTheyAreOne) {
  std::vector<int> order;
  doAll(1, {[&] { order.push_back(1); }, [&] { order.push_back(2); }, [&] { order.push_back(3); }});
  EXPECT_EQ(order, (std::vector{1, 2, 3}));
}

TEST(Threads, ThrowHereWhatAPieceThrows) {
  EXPECT_THROW(doAll(2, {[] {}, [] { throw std::runtime_error("in a piece"); }}), std::runtime_error);
}

TEST(Threads, AreOfNoUseForFewRows) {
  EXPECT_EQ(threadsFor(0), 1u);
  EXPECT_EQ(threadsFor(500), 1u);
  EXPECT_GE(threadsFor(1'000'000), 1u);
}

}  // namespace
}  // namespace alidade
