#include "core/wording/diagnosis_sentence.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

KnownCheck collimation() {
  return {.effect = "collimation",
          .name = "collimation",
          .unit = "arcsec",
          .known = 3.2,
          .sigmaKnown = 0.5,
          .from = "instrument record t-1 of 2026-03-01",
          .date = "2026-03-01",
          .value = 41.04,
          .sigma = 1.9,
          .isSeen = true,
          .staleChance = 0.9999};
}

TEST(KnownChecks, SayWhatIsStale) {
  Diagnosis diagnosis;
  diagnosis.known = {collimation()};
  EXPECT_EQ(staleSentence(diagnosis), "") << "no cause";
  diagnosis.causes = {{.effect = "collimation",
                       .probability = 0.9999,
                       .parameters = {},
                       .indistinguishableFrom = {},
                       .readings = {}}};
  EXPECT_EQ(staleSentence(diagnosis), "") << "a cause like others";
  diagnosis.causes[0].isStale = true;
  EXPECT_EQ(staleSentence(diagnosis),
            "According to instrument record t-1 of 2026-03-01, collimation is 3.20 ± 0.50″; these readings "
            "give 41.0 ± "
            "1.9″: the known size is out of date with a probability of more than 99.9 %.");
  diagnosis.known[0].isSeen = false;
  EXPECT_EQ(staleSentence(diagnosis), "");
}

TEST(KnownChecks, SayWhatOnlyTheRecordTellsApart) {
  Diagnosis diagnosis;
  diagnosis.causes = {{.effect = "vertical_drift",
                       .probability = 0.9,
                       .parameters = {},
                       .indistinguishableFrom = {},
                       .readings = {}}};
  diagnosis.known = {collimation(), collimation()};
  diagnosis.known[0].effect = "trunnion_tilt";
  diagnosis.causes[0].unlessStale = {"trunnion_tilt"};
  diagnosis.causes[0].indistinguishableFrom = {"collimation", "plane_warp"};
  EXPECT_EQ(staleSentence(diagnosis),
            "If the known size of trunnion tilt or collimation were out of date, these readings could not "
            "distinguish this from vertical drift.");
}

TEST(KnownChecks, TellOfTheNumberThatDepartsFarthest) {
  Diagnosis diagnosis;
  diagnosis.causes = {{.effect = "plane_tilt",
                       .probability = 0.9,
                       .parameters = {},
                       .indistinguishableFrom = {},
                       .readings = {}}};
  diagnosis.causes[0].isStale = true;
  for (const char* name : {"tilt about x", "tilt about y"})
    diagnosis.known.push_back({.effect = "plane_tilt",
                               .name = name,
                               .unit = "deg",
                               .known = 0,
                               .sigmaKnown = 0.01,
                               .from = {},
                               .date = {},
                               .value = name[11] == 'y' ? 0.2 : 0.01,
                               .sigma = 0.01,
                               .isSeen = true});
  EXPECT_NE(
      staleSentence(diagnosis).find("According to what is known beforehand, plane tilt, tilt about y is"),
      std::string::npos)
      << staleSentence(diagnosis);
}

}  // namespace
}  // namespace alidade
