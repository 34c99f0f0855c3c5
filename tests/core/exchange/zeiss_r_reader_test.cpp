#include "core/exchange/zeiss_r_reader.h"

#include <gmock/gmock.h>

#include "tests/support/file_content.h"

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ZeissR : public ::testing::TestWithParam<const char*> {};

TEST_P(ZeissR, LinesAreRead) {
  const Recording recording =
      readZeissR(contentOf(std::string(ALIDADE_REFERENCE_DIR "/import/read/") + GetParam()));
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 3u);
  EXPECT_TRUE(recording.sightings[0].isZero) << "the text ZERO stands before it";
  const auto& one = recording.sightings[1];
  EXPECT_EQ(one.line, 5u);
  EXPECT_EQ(one.row.point, "1");
  EXPECT_EQ(one.row.note, "SLI");
  EXPECT_EQ(one.row.horizontal, "107.1225gon");
  EXPECT_EQ(one.row.vertical, "98.4730gon");
  EXPECT_EQ(recording.verticalCircle, "zenith");
  EXPECT_THAT(recording.unused, Contains(HasSubstr("a line without angles")));
  EXPECT_THAT(recording.unused, Contains("the text “HOLD” is not used: line 4"))
      << "a held angle is no sighting";
}

INSTANTIATE_TEST_SUITE_P(Both, ZeissR, ::testing::Values("elta.r4", "elta.r5"),
                         [](const auto& tested) { return std::string(tested.param).substr(5); });

TEST(ZeissRLines, KeepEveryUnitAndKindOfCircle) {
  const auto sightingOf = [](const std::string& values) {
    const Recording recording = readZeissR("For R4|PR XYZ1234|" + values + "|\n");
    return recording.problems.empty()
               ? recording.sightings.at(0).row.horizontal + " " + recording.sightings.at(0).row.vertical +
                     " " + recording.verticalCircle
               : recording.problems[0].what;
  };
  EXPECT_EQ(sightingOf("Hz     107.1223 DMS|V3       1.1229 DMS"), "107 12 23 1 12 29 elevation");
  EXPECT_EQ(sightingOf("Hz     107.2065 DEG|V1      88.7921 DEG"), "107.2065° 88.7921° zenith");
  EXPECT_THAT(sightingOf("Hz     107.1225|V1      98.4730 gon"), HasSubstr("“107.1225” is no angle in gon"));
  EXPECT_THAT(sightingOf("Hz     107.1225 gon|V2      98.4730 gon"), HasSubstr("“V2” is neither"));
}

TEST(ZeissRLines, AfterTheEndOfTheFileAreToldOf) {
  const std::string line = "For R4|PR XYZ1234|Hz     107.1225 gon|V1      98.4730 gon|\n";
  const Recording recording = readZeissR(line + "\x1A\n" + line);
  EXPECT_EQ(recording.sightings.size(), 1u);
  EXPECT_THAT(recording.unused, Contains(HasSubstr("after the end of the file (^Z) is not used: line 2")));
}

}  // namespace
}  // namespace alidade::test
