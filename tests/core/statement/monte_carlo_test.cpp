#include "core/statement/budget.h"

#include <gmock/gmock.h>

#include <cmath>

namespace alidade {
namespace {

using testing::HasSubstr;

/// A thousand draws and a tolerance of 0.005 mm.
MonteCarlo differing(double low, LinearPropagation linear) {
  MonteCarlo check;
  check.draws = 1000;
  check.tolerance = 0.005;
  check.lowDifference = low;
  check.highDifference = 0.002;
  check.endpointSigma = 0.004;
  check.linear = linear;
  return check;
}

TEST(MonteCarloStatement, SaysWhatFollows) {
  MonteCarlo check = differing(0.031, LinearPropagation::Refuted);
  EXPECT_EQ(
      agreementSentence(check),
      "The ends of Δd ± U differ by 0.0310 and 0.0020 mm from the simulated ends; the numerical tolerance "
      "is 0.0050 mm. Rely on the simulated interval.");
  check.failed = 1;
  EXPECT_THAT(agreementSentence(check), HasSubstr("Draws without a result (excluded): 1."));
}

TEST(MonteCarloStatement, SaysHowManyDrawsWouldTell) {
  MonteCarlo check = differing(0.003, LinearPropagation::Undecided);
  EXPECT_EQ(agreementWord(check), "No disagreement, but too few draws to be sure.");
  EXPECT_THAT(
      agreementSentence(check),
      HasSubstr("an end of the interval is uncertain by 0.0040 mm: a decision needs about 6000 draws."))
      << "1000 · (3 · 0.004/0.005)²";
  check.lowDifference = 0.0091;
  EXPECT_EQ(agreementWord(check), "Too few draws to decide.");
  EXPECT_THAT(agreementSentence(check), HasSubstr(": a decision needs about 9000 draws."))
      << "1000 · (3 · 0.004/(0.0091 − 0.005))²";
  check.lowDifference = 0.016;
  EXPECT_THAT(agreementSentence(check), HasSubstr(": a decision needs about 6000 draws."))
      << "the tolerance is the smaller room";
  check.lowDifference = check.tolerance;
  EXPECT_EQ(agreementWord(check), "No disagreement, but too few draws to be sure.");
  EXPECT_THAT(agreementSentence(check), HasSubstr(": a decision needs about 6000 draws."))
      << "at the tolerance is within it";
  check.lowDifference = std::nextafter(check.tolerance, 1);
  EXPECT_THAT(agreementSentence(check), HasSubstr(": a decision needs more draws than can be set here."));
}

}  // namespace
}  // namespace alidade
