#include "ui/import/import_source.h"

#include <gmock/gmock.h>

namespace alidade::ui::test {
namespace {

using ::testing::HasSubstr;

TEST(ImportSource, FollowsTheTableOfFormats) {
  for (const char* pattern : {"*.gsi", "*.GSI", "*.jxl", "*.xml", "*.r5", "*.csv"})
    EXPECT_TRUE(readingsPatterns().split(u' ').contains(QLatin1String(pattern))) << pattern;
  EXPECT_FALSE(readingsPatterns().contains(QLatin1String("*.rw5"))) << "what is not read is not offered";
  for (const char* name : {"a.gsi", "a.JXL", "a.csv", "a.rw5", "a.xlsx", "a.dxf"})
    EXPECT_TRUE(isReadingsFile(QLatin1String(name))) << name;
  for (const char* name : {"a.alidade", "report.pdf", "a.json", "gsi"})
    EXPECT_FALSE(isReadingsFile(QLatin1String(name))) << name;
}

TEST(ImportSource, NamesAFormatThatIsNotRead) {
  const auto sources = readSources({QStringLiteral(ALIDADE_REFERENCE_DIR "/import/named/survce.rw5")});
  ASSERT_FALSE(sources);
  EXPECT_THAT(sources.problem().what, HasSubstr("“survce.rw5” cannot be imported."));
  EXPECT_THAT(sources.problem().what, HasSubstr("is a file of the format Carlson RW5 / TDS RAW"));
}

TEST(ImportSource, RecognisesAFormatThatIsRead) {
  const auto sources = readSources({QStringLiteral(ALIDADE_REFERENCE_DIR "/import/read/access.jxl")});
  ASSERT_TRUE(sources) << sources.problem().text();
  EXPECT_EQ(sources->front().recognised.name, "Trimble JobXML");
  EXPECT_TRUE(sources->front().recognised.saysAxis) << "by a note";
}

}  // namespace
}  // namespace alidade::ui::test
