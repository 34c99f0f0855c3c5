#include "core/base/limits.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(Limits, AreToldInRoundNumbers) {
  EXPECT_EQ(limits::asMebibytes(limits::mostBytes), "512 MiB");
  EXPECT_EQ(limits::asCount(0), "0");
  EXPECT_EQ(limits::asCount(999), "999");
  EXPECT_EQ(limits::asCount(1000), "1,000");
  EXPECT_EQ(limits::asCount(limits::mostRows), "2,000,000");
  EXPECT_EQ(limits::tooManyBytes().what, "is larger than 512 MiB: choose another file");
}

}  // namespace
}  // namespace alidade
