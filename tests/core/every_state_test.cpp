// A session has a result or a sentence in every state while it is typed, and in every geometry. The plans of
// 9 or 17 points in other tests prove nothing about 24.

#include <gtest/gtest.h>

#include <string>

#include "tests/support/every_answer.h"
#include "tests/support/far_off.h"
#include "tests/support/guarded_memory.h"
#include "tests/support/typing.h"

namespace alidade {
namespace {

using namespace alidade::test;

/// Tests every second of 1750 states, since consecutive states differ by one entry only. Shards run in
/// parallel.
class EveryState : public testing::TestWithParam<int> {};

TEST_P(EveryState, OfTypingHasAnAnswerOrASentence) {
  constexpr int states = inTheTime(125);
  const std::uint64_t shard = 4200000 + 250 * static_cast<std::uint64_t>(GetParam());
  int passed = 0;
  for (std::uint64_t seed = shard; passed < states && !HasFailure(); ++seed) {
    Typing typing(seed);
    for (std::uint64_t state = seed; typing.next() && passed < states && !HasFailure(); ++state) {
      if (state % 2 != 0) continue;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", state " + std::to_string(state - seed));
      try {
        expectAnswers(typing.session());
        if (++passed % 8 == 5) expectFurtherAnswers(typing.session());
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
      }
      if (HasFailure()) ADD_FAILURE() << writeSession(typing.session());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sample, EveryState, testing::Values(0));
INSTANTIATE_TEST_SUITE_P(Long, EveryState, testing::Range(1, 7));

class EveryGeometry : public testing::TestWithParam<int> {};

TEST_P(EveryGeometry, HasAnAnswerOrASentence) {
  constexpr int sessions = inTheTime(40);
  const std::uint64_t shard = 5200000 + 1000 * static_cast<std::uint64_t>(GetParam());
  for (std::uint64_t seed = shard; seed < shard + sessions && !HasFailure(); ++seed) {
    std::mt19937_64 random(seed);
    const DrawnPlan plan = drawnPlan(random, seed % 8 == 0 ? 500 : 60, seed);
    const Result<Session> session = simulate(plan.protocol, plan.truth, seed);
    if (!session) {
      expectSentence(session.problem().text());
      continue;
    }
    SCOPED_TRACE("seed " + std::to_string(seed));
    try {
      expectAnswers(*session);
      expectFurtherAnswers(*session);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    if (HasFailure()) ADD_FAILURE() << writeSession(*session);
  }
}

INSTANTIATE_TEST_SUITE_P(Sample, EveryGeometry, testing::Values(0));
INSTANTIATE_TEST_SUITE_P(Long, EveryGeometry, testing::Range(1, 7));

/// Inputs without an arc.
class EveryFarOff : public testing::TestWithParam<int> {};

TEST_P(EveryFarOff, HasAnAnswerInItsRangesOrASentence) {
  constexpr int sessions = inTheTime(50);
  const std::uint64_t shard = 6200000 + 1000 * static_cast<std::uint64_t>(GetParam());
  for (std::uint64_t seed = shard; seed < shard + sessions && !HasFailure(); ++seed) {
    const Session session = FarOffSession(seed).session();
    SCOPED_TRACE("seed " + std::to_string(seed));
    try {
      expectAnswers(session);
      if (seed % 8 == 0) expectFurtherAnswers(session);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    if (HasFailure()) ADD_FAILURE() << writeSession(session);
  }
}

INSTANTIATE_TEST_SUITE_P(Sample, EveryFarOff, testing::Values(0));
INSTANTIATE_TEST_SUITE_P(Long, EveryFarOff, testing::Range(1, 8));

}  // namespace
}  // namespace alidade
