#include "core/base/phrase.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

std::string french(const char* english) {
  return english == std::string("%1 of %2") ? "de %2, %1" : english;
}

TEST(Phrase, PutsTheValuesWhereTheirMarksAre) {
  EXPECT_EQ(Phrase::of("the radius of %1 is %2 % off", "0°", 12), "the radius of 0° is 12 % off");
  EXPECT_EQ(Phrase::of("%2 before %1, and %2 again", "a", std::string("b")), "b before a, and b again");
}

TEST(Phrase, LeavesWhatIsNoMarkOrHasNoValue) {
  EXPECT_EQ(Phrase::of("95 %"), "95 %");
  EXPECT_EQ(Phrase::of("%1 and %3, 100%", "a"), "a and %3, 100%");
}

TEST(Phrase, DoesNotLookThroughValuesForMarks) {
  EXPECT_EQ(Phrase::of("%1, %2", "%2", "%1"), "%2, %1");
}

TEST(Phrase, SpeaksAsItsInterpreterDoes) {
  Phrase::setInterpreter(french);
  const std::string ordered = Phrase::of("%1 of %2", 3, "17"), other = Phrase::of("%1 rows", 2);
  Phrase::setInterpreter(nullptr);
  EXPECT_EQ(ordered, "de 17, 3");
  EXPECT_EQ(other, "2 rows");
  EXPECT_EQ(Phrase::of("%1 of %2", 3, "17"), "3 of 17");
}

}  // namespace
}  // namespace alidade
