#include "core/base/list_text.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(ListText, PartsTheEntries) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"a"}, " or "), "a");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(listed({"a", "b"}, " or "), "a or b");
  EXPECT_EQ(listed({"a", "b", "c"}, " and "), "a, b and c");
}

TEST(ListText, CountsOneAsOne) {
  EXPECT_EQ(counted(0, "row"), "0 rows");
  EXPECT_EQ(counted(1, "row"), "1 row");
  EXPECT_EQ(counted(2, "reading"), "2 readings");
}

}  // namespace
}  // namespace alidade
