#include "core/wording/budget.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(BeyondInWords, SaysWhatWasAveraged) {
  EXPECT_EQ(textOf(Beyond::Nothing), "");
  EXPECT_EQ(textOf(Beyond::Pattern), "with the pattern's possible effect");
  EXPECT_EQ(textOf(Beyond::LookAlikes), "averaged over the indistinguishable causes");
  EXPECT_EQ(textOf(Beyond::Others), "averaged over the possible explanations");
}

}  // namespace
}  // namespace alidade
