#include "core/base/file_bytes.h"

#include <gmock/gmock.h>

namespace alidade::test {
namespace {

using ::testing::HasSubstr;

TEST(ReadFile, GivesTheBytes) {
  const Result<std::string> bytes = readFile(ALIDADE_REFERENCE_DIR "/paper-table-1.csv");
  ASSERT_TRUE(bytes);
  EXPECT_TRUE(bytes->starts_with("axis_deg,point"));
}

TEST(ReadFile, SaysWhyItCannot) {
  EXPECT_THAT(readFile(ALIDADE_REFERENCE_DIR).problem().what, HasSubstr("folder"));
  EXPECT_THAT(readFile(ALIDADE_REFERENCE_DIR "/nothing").problem().what, HasSubstr("cannot be opened"));
}

}  // namespace
}  // namespace alidade::test
