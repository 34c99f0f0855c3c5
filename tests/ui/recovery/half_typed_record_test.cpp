#include "ui/recovery/half_typed_record.h"

#include <gmock/gmock.h>

namespace alidade::ui {
namespace {

TEST(HalfTypedRecord, IsReadAsItWasWritten) {
  const HalfTypedRecord record{
      .of = QStringLiteral("4711"),
      .texts = {{.place = {.position = 1, .reading = 17, .field = "vertical"}, .text = "88° 4"},
                {.place = {.field = "value"}, .effect = "trunnion_tilt", .parameter = "tilt", .text = "1\"2"},
                {.place = {.position = 0, .reading = 17, .field = "horizontal"},
                 .point = "9",
                 .round = "2",
                 .face = "1",
                 .text = "34"},
                {.place = {.reading = 3, .field = "journal"}, .text = "digits exchanged", .count = 2},
                {.place = {.field = "notes"}, .text = "two\nlines, µ"}}};
  const auto read = readHalfTypedRecord(halfTypedRecordText(record));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, record);
}

TEST(HalfTypedRecord, RefusesWhatIsNone) {
  for (const std::string& bad :
       {std::string(), std::string("{}"), std::string("[1"), std::string("{\"of\": 1}")})
    EXPECT_FALSE(readHalfTypedRecord(bad)) << bad;
}

}  // namespace
}  // namespace alidade::ui
