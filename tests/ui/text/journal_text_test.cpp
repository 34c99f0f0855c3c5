#include "ui/text/journal_text.h"

#include <gtest/gtest.h>

namespace alidade::ui {
namespace {

/// The journal's name of an entry, by the place of the entry in the session file.
TEST(JournalText, NamesEachPlaceAsThePageDoes) {
  const auto placeOf = [](const char* place) {
    JournalEntry entry;
    entry.place = place;
    entry.axis = "180";
    entry.point = "7";
    return journalPlace(entry).toStdString();
  };
  EXPECT_EQ(placeOf("positions[1].readings[2].excluded"), "180°, row 3 (point 7), use")
      << "from “used” to “excluded”";
  EXPECT_EQ(placeOf("positions[1].readings[2].vertical"), "180°, row 3 (point 7), vertical reading");
  EXPECT_EQ(placeOf("positions[1].readings[2]"), "180°, row 3 (point 7)");
  EXPECT_EQ(placeOf("model.effects"), "model effects");
  EXPECT_EQ(placeOf("instrument.known[1]"), "known value of the instrument");
  EXPECT_EQ(placeOf("device.known[0]"), "known value of the device");
  EXPECT_EQ(placeOf("own_effects"), "own effects");
  EXPECT_EQ(placeOf("moon.light"), "moon.light") << "of a later version";
}

}  // namespace
}  // namespace alidade::ui
