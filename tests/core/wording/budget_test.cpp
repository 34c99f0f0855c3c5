#include "core/wording/budget.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

// The console's JSON has these names.
TEST(BudgetInWords, NamesEachSource) {
  EXPECT_EQ(textOf(UncertaintySource::Readings), "readings");
  EXPECT_EQ(textOf(UncertaintySource::ModelEffects), "model effects");
  EXPECT_EQ(textOf(UncertaintySource::KnownRadius), "known radius");
  EXPECT_EQ(textOf(UncertaintySource::PointingZeros), "pointing zeros");
  EXPECT_EQ(textOf(UncertaintySource::Distance), "distance");
}

}  // namespace
}  // namespace alidade
