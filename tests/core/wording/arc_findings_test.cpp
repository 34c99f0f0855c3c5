#include "core/wording/findings.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

using namespace arc_finding;

std::string textOf(int axisDeg, What what) {
  return wordsOf(ArcFinding{axisDeg, std::move(what)}).text;
}

TEST(ArcFindingsInWords, NameTheirArc) {
  EXPECT_EQ(textOf(180, NotConverged{60}),
            "180°: the fit did not converge within 60 iterations; its result is unreliable.");
}

TEST(ArcFindingsInWords, StateTheirNumbers) {
  EXPECT_EQ(textOf(0, ScattersMore{49, 31}),
            "0°: the readings scatter 7.0 times their stated noise (reduced χ² 49.00 with 31 degrees of "
            "freedom).");
  EXPECT_EQ(textOf(0, ScattersLess{0.01, 31}),
            "0°: the readings agree far better than their stated noise (reduced χ² 0.01 with 31 degrees of "
            "freedom).");
  EXPECT_EQ(textOf(0, RadiusPoorlyKnown{Angle::fromDegrees(4.96), 12.04}),
            "0°: an arc of 5.0° determines the radius only to u = 12.0 mm, and the centre hardly better.");
  EXPECT_EQ(textOf(0, RadiusFarFromNominal{400, 300}),
            "0°: the fitted radius 400.0 mm is far from the nominal 300.0 mm.");
}

// Rows count from 1 for people, as in the table.
TEST(ArcFindingsInWords, NameThreePairsOfRowsAtMost) {
  EXPECT_EQ(textOf(0, ReadingsRepeat{{{3, 4}}}),
            "0°: the same pair of readings occurs twice, in rows 4 and 5.");
  EXPECT_EQ(textOf(0, ReadingsRepeat{{{0, 1}, {2, 3}, {4, 5}}}),
            "0°: the same pair of readings occurs twice, in rows 1 and 2, 3 and 4, 5 and 6.");
  EXPECT_EQ(textOf(0, ReadingsRepeat{{{0, 1}, {2, 3}, {4, 5}, {6, 7}}}),
            "0°: the same pair of readings occurs twice, in rows 1 and 2, 3 and 4, 5 and 6, ….");
}

TEST(ArcFindingsInWords, AllSayWhatToDo) {
  for (const What& what :
       {What(NotConverged{}), What(NothingChecks{}), What(ScattersMore{}), What(ScattersLess{}),
        What(RadiusPoorlyKnown{}), What(RadiusFarFromNominal{}), What(ReadingsRepeat{{{0, 1}}})})
    EXPECT_FALSE(wordsOf(ArcFinding{0, what}).remedy.empty()) << what.index();
}

}  // namespace
}  // namespace alidade
