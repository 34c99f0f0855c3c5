#include "core/wording/journal.h"

#include <gtest/gtest.h>

namespace alidade::test {
namespace {

std::string shown(const std::string& place, const std::string& text) {
  return contentText({.place = place, .to = text}, text);
}

// The file contains ids of effects; the journal of window and report shows their names.
TEST(JournalContent, NamesEffects) {
  EXPECT_EQ(shown("model.effects", "collimation, trunnion_tilt"), "collimation, trunnion tilt");
  EXPECT_EQ(shown("model.effects", ""), "");
  EXPECT_EQ(shown("instrument.known[1]", "trunnion_tilt: 12 ± 2 arcsec, certificate K-7: 2025"),
            "trunnion tilt: 12 ± 2 arcsec, certificate K-7: 2025");
  EXPECT_EQ(shown("device.known[0]", "vertical_axis_tilt tilt about x: 1 ± 2 arcsec"),
            "vertical axis tilt, tilt about x: 1 ± 2 arcsec");
}

TEST(JournalContent, LeavesWhatWasTyped) {
  for (const char* text : {"", "trunnion_tilt", "trunnion_tilt: 3", "a: b"})
    EXPECT_EQ(shown("notes", text), text);
  for (const char* text : {"", "trunnion_tilt", "no effect: 3", ": 3"})
    EXPECT_EQ(shown("instrument.known[0]", text), text);
}

}  // namespace
}  // namespace alidade::test
