#include "core/base/problem.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(Problem, PutsThePlaceInFrontOfTheSentence) {
  EXPECT_EQ((Problem{"is empty", {.position = 1, .reading = 3, .field = "vertical"}}).text(),
            "positions[1].readings[3].vertical: is empty");
  EXPECT_EQ((Problem{"is empty: choose a session file"}).text(), "is empty: choose a session file");
}

}  // namespace
}  // namespace alidade
