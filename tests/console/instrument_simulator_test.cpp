#include <gmock/gmock.h>

#include "tests/console/console.h"

// The window tests cover its communication; here are its refusals.

namespace alidade::test {
namespace {

using testing::HasSubstr;

TEST(InstrumentSimulator, SaysWhatItCannotTell) {
  const ProgramRun none = alidadeCli({"instrument-simulator", "there-is-none.alidade"});
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.err, HasSubstr("there-is-none.alidade"));
  const ProgramRun fault = alidadeCli({"instrument-simulator", "--fault", "thunder"});
  EXPECT_EQ(fault.exitCode, 2);
  EXPECT_THAT(fault.err, HasSubstr("thunder"));
  const TemporaryFolder folder;
  const std::string empty = folder.file(
      "empty.alidade",
      R"({"format": "alidade-session", "version": 1, "geometry": {"distance_mm": 1, "radius_mm": 1},
                           "positions": []})");
  const ProgramRun nothing = alidadeCli({"instrument-simulator", empty});
  EXPECT_EQ(nothing.exitCode, 2);
  EXPECT_THAT(nothing.err, HasSubstr("no readings"));
}

}  // namespace
}  // namespace alidade::test
