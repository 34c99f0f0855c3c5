#include "core/simulation/sealed_truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/simulation/truth_text.h"

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string problemOf(const std::string& text) {
  const auto truths = readSealedTruths(text);
  EXPECT_FALSE(truths) << text;
  return truths ? "" : truths.problem().text();
}

TEST(SealedTruth, ReadsWhatScoringNeeds) {
  const auto truths = *readSealedTruths(R"({
    "007": {"kind": "arc_lobing", "intersection_mm": -1.5, "protocol": "full", "visible_sigma": 9.5,
            "look_alikes": [["arc_ellipticity", 0.98, 2.1], ["gravity_sag", 0.9, 4.0]], "surplus": 1},
    "008": {"kind": "gross_error", "intersection_mm": 0, "visible_sigma": null,
            "blunders": [[1, 2, 13, 2, -60, 0], [0, 1, 6, 1, 0, 30]]},
    "009": {"kind": "two_causes", "intersection_mm": 2, "causes": ["collimation", "arc_lobing"]}})");
  ASSERT_EQ(truths.size(), 3u);
  EXPECT_EQ(truths[0].id, "007");
  EXPECT_EQ(truths[0].protocol, "full");
  EXPECT_THAT(truths[0].causes, ElementsAre("arc_lobing"));
  EXPECT_EQ(truths[0].visible, 9.5);
  EXPECT_THAT(truths[0].lookAlikes, ElementsAre("arc_ellipticity", "gravity_sag"));
  EXPECT_FALSE(truths[1].visible);
  EXPECT_THAT(truths[1].grossErrors, ElementsAre(GrossErrorCell{0, 1, 6, 1, ReadingKind::Vertical},
                                                 GrossErrorCell{180, 2, 13, 2, ReadingKind::Horizontal}));
  EXPECT_THAT(truths[2].causes, ElementsAre("collimation", "arc_lobing"));
  EXPECT_EQ(truths[2].intersection, 2);
}

TEST(SealedTruth, NamesTheTruthAndTheKeyThatAreWrong) {
  EXPECT_THAT(problemOf("[1, 2]"), HasSubstr("no JSON object"));
  EXPECT_THAT(problemOf("{"), HasSubstr("no JSON object"));
  EXPECT_THAT(problemOf("{}"), HasSubstr("nothing to score"));
  EXPECT_THAT(problemOf(R"({"a1": {"kind": "none"}})"), HasSubstr("“a1”: intersection_mm"));
  EXPECT_THAT(problemOf(R"({"a1": {"kind": 3, "intersection_mm": 0}})"), HasSubstr("“a1”: kind"));
  EXPECT_THAT(problemOf(R"({"a1": 5})"), HasSubstr("“a1”"));
  EXPECT_THAT(problemOf(R"({"a1": {"kind": "none", "intersection_mm": 0, "blunders": [[0]]}})"),
              HasSubstr("blunders"));
}

// A typing error in the truth would only score as a wrong answer.
TEST(SealedTruth, RefusesWhatNoAnswerCanBeRightFor) {
  const auto problemWith = [](const std::string& members) {
    return problemOf(R"({"a1": {"intersection_mm": 0, )" + members + "}}");
  };
  EXPECT_THAT(problemWith(R"("kind": "trunion_tilt")"), HasSubstr("“a1”: kind is “trunion_tilt”"));
  EXPECT_THAT(problemWith(R"("kind": "gross_error")"), HasSubstr("“a1”: blunders must list"));
  EXPECT_THAT(problemWith(R"("kind": "gross_error", "blunders": [[0, 1, 6, 1, 0, 0]])"),
              HasSubstr("blunders must list"));
  for (const char* place : {"0, 1, 3, 1e118", "0, 1e10, 3, 1", "0, 1, 2.5, 1"})
    EXPECT_THAT(problemWith(R"("kind": "gross_error", "blunders": [[)" + std::string(place) + ", 60, 0]]"),
                HasSubstr("blunders is missing or of the wrong type"))
        << place;
  EXPECT_THAT(problemWith(R"("kind": "two_causes")"), HasSubstr("“a1”: causes must name them"));
  EXPECT_THAT(problemWith(R"("kind": "two_causes", "causes": ["collimation", "moonlight"])"),
              HasSubstr("causes names “moonlight”"));
  EXPECT_THAT(problemWith(R"("kind": "collimation", "visible_sigma": -5)"),
              HasSubstr("visible_sigma must not be negative"));
}

// Sets made elsewhere may contain kinds unknown here.
TEST(SealedTruth, TakesEveryKindOfNoCatalogue) {
  for (const char* kind :
       {"unknown_refraction", "unknown_tripod_of_wood", "unknown", "radial_bump", "settling"}) {
    const auto truths = readSealedTruths(
        R"({"a1": {"intersection_mm": 0, "look_alikes": [["moonlight", 0.9, 2]], "kind": ")" +
        std::string(kind) + "\"}}");
    ASSERT_TRUE(truths) << kind;
    EXPECT_THAT(truths->front().causes, ElementsAre(kind));
  }
}

// Other test generators have other names for an effect, and a name for all effects together. A series is not
// a session.
TEST(SealedTruth, KnowsWhatOtherRefereesCallIt) {
  const auto truths = *readSealedTruths(R"({
    "a": {"kind": "drift_real_v", "intersection_mm": 0, "plan": "far"},
    "b": {"kind": "all", "intersection_mm": 0, "there": {"collimation": 1.0, "arc_lobing": 1.0}},
    "c": {"kind": "trunnion_tilt", "intersection_mm": {"01": 1.5, "02": -1.5}},
    "d": {"kind": "none", "shared": "none", "sessions": {"01": {"intersection_mm": 1}}}})");
  ASSERT_EQ(truths.size(), 2u);
  EXPECT_EQ(truths[0].kind, "vertical_drift");
  EXPECT_EQ(truths[0].protocol, "far");
  EXPECT_EQ(truths[1].kind, "several_causes");
  EXPECT_THAT(truths[1].causes, ElementsAre("arc_lobing", "collimation"));
}

TEST(SealedTruth, IsMadeOfASimulatedTruth) {
  Truth truth = drawTruth(4);
  truth.protocol = "full";
  addEffect(truth, "arc_lobing=0.1,0.02");
  const SealedTruth seal =
      sealed("4", truth, Visibility{.sigma = 8, .lookAlikes = {{"gravity_sag", 0.9, 3}}});
  EXPECT_EQ(seal.kind, "arc_lobing");
  EXPECT_EQ(seal.intersection, truth.intersection);
  EXPECT_EQ(seal.visible, 8);
  EXPECT_THAT(seal.lookAlikes, ElementsAre("gravity_sag"));
  EXPECT_THAT(seal.grossErrors, IsEmpty());
}

// The same truth after writing and reading its file.
TEST(SealedTruth, IsTheSameByWayOfAFile) {
  Truth truth = drawTruth(4);
  truth.protocol = "full";
  addEffect(truth, "gross_error=180,2,3,1,60,0");
  addEffect(truth, "gross_error=0,1,5,2,0,-30");
  addEffect(truth, "gross_error=0,1,5,2,0,-30,2");
  const SealedTruth seal = sealed("4", truth, std::nullopt);
  const SealedTruth read = readSealedTruths(truthJson("4", truth))->front();
  EXPECT_EQ(read.kind, "gross_error");
  ASSERT_EQ(read.grossErrors.size(), 3u);
  EXPECT_EQ(read.grossErrors, seal.grossErrors);
  EXPECT_EQ(read.causes, seal.causes);
  EXPECT_EQ(read.intersection, seal.intersection);
}

}  // namespace
}  // namespace alidade
