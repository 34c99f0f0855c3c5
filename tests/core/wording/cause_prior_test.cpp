#include "core/wording/effect_name.h"

#include <gtest/gtest.h>

#include "core/effects/cause_ids.h"

namespace alidade {
namespace {

// The sizes are those of the catalogue.
TEST(PlausibleSize, IsThatOfTheCatalogue) {
  EXPECT_EQ(plausibleSizeText("trunnion_tilt"), "30″");
  EXPECT_EQ(plausibleSizeText("arc_lobing"), "0.05 mm");
  EXPECT_EQ(plausibleSizeText("slider_scale"), "0.0005");
  EXPECT_EQ(plausibleSizeText(std::string(jumpId)), "");
}

}  // namespace
}  // namespace alidade
