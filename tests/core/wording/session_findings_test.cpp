#include "core/wording/findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using namespace session_finding;
using testing::HasSubstr, testing::Not, testing::StartsWith;

TEST(SessionFindingsInWords, StateTheirNumbers) {
  EXPECT_EQ(
      wordsOf(CentresDiffer{0.6483, 0.3}).text,
      "Along the axis the centres at 0° and 180° differ by 0.648 mm, more than readings and zeros allow "
      "(0.300 mm at 0.1 % risk).");
  EXPECT_EQ(wordsOf(RadiiDiffer{1.9591, 0.2004}).text,
            "The radii of the one rigid arc at 0° and 180° differ by 1.959 mm, more than their noise allows "
            "(0.200 mm at 0.1 % risk).");
  EXPECT_EQ(wordsOf(KnownRadiusContradicted{400, -0.0312, 0.0201}).text,
            "The readings disagree with the known radius of 400 mm: they shift it by −0.0312 mm; the noise "
            "of the readings and the σ of the radius allow at most 0.0201 mm at 0.1 % risk.");
}

TEST(SessionFindingsInWords, NameTheArcOrThePosition) {
  EXPECT_THAT(wordsOf(ArcMissing{0, arc_fault::TooFewPlaces{2}}).text,
              StartsWith("The arc at 0° has readings of 2 places; "));
  EXPECT_EQ(wordsOf(ArcMissing{180, arc_fault::RadiusUndetermined{}}).text.back(), '.');
  EXPECT_THAT(wordsOf(PositionMissing{180}).text, HasSubstr("no usable position at 180°"));
}

TEST(SessionFindingsInWords, BlameEffectsOnlyWhereThereAreAny) {
  EXPECT_THAT(wordsOf(Undetermined{true}).text, HasSubstr("effects of the model"));
  EXPECT_THAT(wordsOf(Undetermined{true}).remedy, HasSubstr("out of the model"));
  EXPECT_THAT(wordsOf(Undetermined{false}).text, Not(HasSubstr("effects")));
  EXPECT_THAT(wordsOf(Undetermined{false}).remedy, Not(HasSubstr("model")));
}

// The text may be anything that was typed.
TEST(SessionFindingsInWords, QuoteWhatIsNoEffect) {
  EXPECT_THAT(wordsOf(UnknownEffect{"moon\x1blight"}).text, HasSubstr("“moon\\u001blight”, which is no"));
  EXPECT_EQ(wordsOf(KnownOfNothing{"plane_tilt", "x", "mm"}).text,
            "The known size of “plane_tilt” (“x”) in “mm” matches no entry of the catalogue.");
}

}  // namespace
}  // namespace alidade
