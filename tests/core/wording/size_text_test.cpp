#include "core/wording/size_text.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(SizeText, HasTheValueToTheDecimalsOfItsUncertainty) {
  EXPECT_EQ(sizeWithExpanded(1.30764, 0.2036, "mm"), "1.31 ± 0.20 mm");
  EXPECT_EQ(sizeWithExpanded(-1.30764, 0.0996, "1"), "−1.31 ± 0.10");
  EXPECT_EQ(sizeWithExpanded(401.954264, 0.0147, "mm"), "401.954 ± 0.015 mm");
}

}  // namespace
}  // namespace alidade
