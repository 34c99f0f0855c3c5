#include "core/wording/suspects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace alidade {
namespace {

using testing::EndsWith, testing::HasSubstr, testing::StartsWith;

Place cell(std::size_t row, const char* field) {
  return {.position = 0, .reading = row, .field = field};
}

Suspect suspectAt(const char* field, Angle size) {
  Suspect suspect;
  suspect.where = cell(4, field);
  suspect.point = 5;
  suspect.size = size;
  return suspect;
}

TEST(SuspectInWords, SaysByHowMuch) {
  EXPECT_EQ(sentenceOf(suspectAt("vertical", Angle::fromArcseconds(29.04))),
            "0°, point 5, vertical: off by +29.0″. No single gross error explains the value: read it again.");
  EXPECT_THAT(sentenceOf(suspectAt("vertical", Angle::fromArcseconds(-119.9))), HasSubstr("off by −119.9″."));
  EXPECT_THAT(sentenceOf(suspectAt("vertical", Angle::fromDegrees(1))), HasSubstr("off by +1°"));
  EXPECT_THAT(sentenceOf(suspectAt("face", Angle::fromDegrees(180))), HasSubstr("face: the wrong face."));
  const Angle none = Angle::fromRadians(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(sentenceOf(suspectAt("vertical", none)), HasSubstr("vertical: not an angle."));
}

TEST(SuspectInWords, NamesRoundAndFaceWhereTheyAreNotOne) {
  Suspect suspect = suspectAt("vertical", Angle::fromArcseconds(29));
  suspect.round = 2;
  suspect.face = 2;
  EXPECT_THAT(sentenceOf(suspect), StartsWith("0°, point 5, round 2, face 2, vertical: "));
}

TEST(SuspectInWords, SaysWhatWasProbablyMeant) {
  Suspect suspect = suspectAt("vertical", Angle::fromArcseconds(29));
  suspect.proposals = {{.error = EntryError::DigitsSwapped,
                        .changes = {{cell(4, "vertical"), "88°16'49\"", "88°61'49\""}},
                        .residual = Angle::fromArcseconds(1.2)}};
  EXPECT_THAT(
      sentenceOf(suspect),
      EndsWith("Probably meant: Vertical 88°61'49\" → 88°16'49\": two digits swapped; the residual becomes "
               "+1.2″."));
}

TEST(SuspectInWords, NamesEveryCellOfAProposal) {
  const Proposal proposal{.error = EntryError::NeighbouringRow,
                          .changes = {{cell(4, "horizontal"), "2°", "1°"}, {cell(5, "horizontal"), "1°", ""}},
                          .residual = Angle()};
  EXPECT_EQ(sentenceOf(proposal),
            "Horizontal 1° → 2°, horizontal of row 6 (empty) → 1°: swapped with the neighbouring row; the "
            "residual becomes +0.0″.");
}

TEST(SuspectInWords, FindingNamesThemAll) {
  EXPECT_FALSE(suspectsFinding({}));
  const Suspect first = suspectAt("vertical", {}), second = suspectAt("slider", {});
  const Finding one = suspectsFinding({first}).value(), both = suspectsFinding({first, second}).value();
  EXPECT_EQ(one.severity, Severity::Warning);
  EXPECT_EQ(one.where, first.where);
  EXPECT_EQ(one.text, "A reading looks misread: 0°, point 5, vertical.");
  EXPECT_EQ(both.where, Place{});
  EXPECT_EQ(both.text, "2 readings look misread: 0°, point 5, vertical; 0°, point 5, slider.");
  EXPECT_THAT(both.remedy, StartsWith("Check them in the field book"));
}

}  // namespace
}  // namespace alidade
