#include "core/wording/beyond.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(BeyondInWords, SaysWhatWasAveraged) {
  EXPECT_EQ(textOf(Beyond::Nothing), "");
  EXPECT_EQ(textOf(Beyond::Pattern), "with what the pattern may move it by");
  EXPECT_EQ(textOf(Beyond::LookAlikes), "averaged over the indistinguishable causes");
  EXPECT_EQ(textOf(Beyond::Others), "averaged over what else may be");
}

}  // namespace
}  // namespace alidade
