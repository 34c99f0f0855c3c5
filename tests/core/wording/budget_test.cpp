#include "core/wording/budget.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

// The console's JSON uses these names.
TEST(BudgetInWords, NamesEachSource) {
  EXPECT_EQ(textOf(UncertaintySource::Readings), "readings");
  EXPECT_EQ(textOf(UncertaintySource::ModelEffects), "model effects");
  EXPECT_EQ(textOf(UncertaintySource::PlausibleSizes), "plausible sizes");
  EXPECT_EQ(textOf(UncertaintySource::KnownRadius), "known radius");
  EXPECT_EQ(textOf(UncertaintySource::PointingZeros), "pointing zeros");
  EXPECT_EQ(textOf(UncertaintySource::Distance), "distance");
}

TEST(BudgetInWords, TellsOfAShareWhatItIsAndHowLargeItMayBe) {
  UncertaintyShare share{.effect = "collimation", .sizes = {{"collimation", 30, "arcsec"}}};
  EXPECT_EQ(textOf(share), "collimation");
  EXPECT_EQ(sizesText(share), "30 arcsec");
  share.sizes = {{"cosine", 0.05, "mm"}, {"sine", 0.05, "mm"}};
  EXPECT_EQ(sizesText(share), "0.05 mm") << "both alike";
  share.sizes = {{"cosine", 0.123456, "mm"}, {"sine", 12345, "mm"}};
  EXPECT_EQ(sizesText(share), "0.123, 12300 mm");
  share.sizes = {{"scale", 5e-4, "1"}};
  EXPECT_EQ(sizesText(share), "0.0005");
  EXPECT_EQ(textOf(UncertaintyShare{.from = UncertaintyShare::From::Diagnosis}),
            "other possible explanations");
  EXPECT_EQ(textOf(UncertaintyShare{.source = UncertaintySource::Distance}), "distance");
  EXPECT_EQ(sizesText({}), "");
}

}  // namespace
}  // namespace alidade
