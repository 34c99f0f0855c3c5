#include "core/base/first_index.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/base/random_source.h"

namespace alidade {
namespace {

/// Maps all keys to a few slots.
struct Crowding {
  std::size_t operator()(int key) const { return static_cast<std::size_t>(key) % 3; }
};

/// Groups of ten.
struct Ten {
  int operator()(int key) const { return key / 10; }
};

template <typename Hash>
void expectAsInAMap(const std::vector<int>& keys) {
  FirstIndex<int, Hash, Ten> firsts(keys.size());
  std::map<int, std::size_t> expected;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::size_t first = expected.emplace(keys[i], i).first->second;
    ASSERT_EQ(firsts.put(keys[i], i), first) << "key " << keys[i] << " of " << keys.size() << " at " << i;
  }
}

TEST(FirstIndex, TellsWhereAKeyCameFirstInAnyOrder) {
  const std::vector<std::vector<int>> lists{
      {},        {7},          {7, 7},       {1, 2, 3, 3}, {3, 2, 1, 3, 2, 1},
      {1, 2, 1}, {1, 2, 3, 2}, {5, 6, 7, 4}, {-1, 0, -1},  {1, 3, 5, 2, 4, 6, 5, 1}};
  for (const std::vector<int>& keys : lists) {
    expectAsInAMap<std::hash<int>>(keys);
    expectAsInAMap<Crowding>(keys);
  }
}

TEST(FirstIndex, TellsItOfManyKeysThatRepeat) {
  RandomSource random(3);
  for (const int different : {2, 40, 3000}) {
    std::vector<int> keys;
    for (int i = 0; i < 2000; ++i) keys.push_back(random.whole(0, different));
    expectAsInAMap<std::hash<int>>(keys);
    expectAsInAMap<Crowding>(keys);
  }
}

// The keys come in groups of up to ten places. Some groups are read again, some are initially longer than the
// table, and one is resumed.
TEST(FirstIndex, TellsItOfGroupsInAnyOrder) {
  RandomSource random(8);
  std::vector<int> keys;
  for (int round = 0; round < 300; ++round)
    for (int place = 0; place < 14; ++place) keys.push_back(10 * round + random.whole(0, 9));
  expectAsInAMap<std::hash<int>>(keys);
  expectAsInAMap<Crowding>(keys);
  for (const int again : {1505, 3, 2999, 4000, 4000}) keys.push_back(again);
  expectAsInAMap<std::hash<int>>(keys);
  std::vector<int> negative;  // groups that descend
  for (int i = 0; i < 200; ++i) negative.push_back(-i % 150);
  expectAsInAMap<std::hash<int>>(negative);
}

// One group has more keys than the table first holds.
TEST(FirstIndex, GrowsWithinAGroup) {
  struct OneGroup {
    int operator()(int /*key*/) const { return 0; }
  };
  FirstIndex<int, std::hash<int>, OneGroup> firsts(2000);
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(firsts.put(static_cast<int>(7 * i), i), i);
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(firsts.put(static_cast<int>(7 * i), 1000 + i), i);
}

TEST(FirstIndex, TakesKeysThatAscendAndThenDoNot) {
  std::vector<int> keys;
  for (int i = 0; i < 1000; ++i) keys.push_back(2 * i);
  for (int i = 0; i < 1000; ++i) keys.push_back(i);
  expectAsInAMap<std::hash<int>>(keys);
}

}  // namespace
}  // namespace alidade
