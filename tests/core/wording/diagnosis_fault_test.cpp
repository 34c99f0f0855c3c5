#include "core/wording/diagnosis_sentence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using testing::HasSubstr;

TEST(DiagnosisFaultInWords, TakesTheReasonOfTheFit) {
  const Place where{.position = 0, .reading = {}, .field = "readings"};
  const NoModel refused{
      FitFinding{Severity::Error, where, session_finding::ArcMissing{0, arc_fault::TooFewPlaces{2}}}};
  EXPECT_THAT(problemOf(refused).what, HasSubstr("The arc at 0° has readings of 2 places"));
  EXPECT_EQ(problemOf(refused).where, where);
  EXPECT_EQ(problemOf(DiagnosisFault(refused)), problemOf(refused));
  EXPECT_THAT(problemOf(NoModel{}).what, HasSubstr("there are no readings"));
}

TEST(DiagnosisFaultInWords, NamesWhatIsUnknownAndThatItWasStopped) {
  EXPECT_EQ(problemOf(DiagnosisFault(UnknownCause{"gremlins"})).what,
            "there is no effect “gremlins” in the catalogue");
  EXPECT_EQ(problemOf(DiagnosisFault(Stopped{})).what, "the diagnosis was stopped");
}

}  // namespace
}  // namespace alidade
