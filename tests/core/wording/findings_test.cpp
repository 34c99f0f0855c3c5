#include "core/wording/findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using testing::ElementsAre, testing::Field, testing::HasSubstr, testing::IsEmpty;

const FitFinding planar{.severity = Severity::Warning,
                        .where = {.position = {}, .reading = {}, .field = "model.vertical_angle"},
                        .what = session_finding::PlanarRelation{}};

TEST(Findings, KeepSeverityAndPlace) {
  const Finding finding = inWords(planar);
  EXPECT_EQ(finding.severity, planar.severity);
  EXPECT_EQ(finding.where, planar.where);
  EXPECT_THAT(finding.text, HasSubstr("y/L"));
  EXPECT_THAT(finding.remedy, HasSubstr("exact"));
}

TEST(Findings, NameTheSuspectsFirst) {
  Suspect suspect;
  suspect.where = {.position = 0, .reading = 4, .field = "vertical"};
  EXPECT_THAT(inWords({}, {}), IsEmpty());
  EXPECT_THAT(inWords({planar}, {suspect}), ElementsAre(Field(&Finding::text, HasSubstr("misread")),
                                                        Field(&Finding::text, HasSubstr("y/L"))));
}

TEST(Findings, JoinSentencesWithOneBlankBetweenThem) {
  EXPECT_EQ(inTurn("One.", "Two."), "One. Two.");
  EXPECT_EQ(inTurn("", "Two."), "Two.");
  EXPECT_EQ(inTurn("One.", ""), "One.");
  EXPECT_EQ(inTurn("", ""), "");
}

}  // namespace
}  // namespace alidade
