#include <gmock/gmock.h>

#include <regex>

#include "tests/console/console.h"

namespace alidade::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

std::string textOf(const std::string& file, const std::string& method = "rigorous") {
  const ProgramRun run = alidadeCli({"fit", file, "--method", method});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return run.out;
}

TEST(FitText, TellsCentresRadiiAndIntersectionOfThePapersReadings) {
  const std::string text = textOf(paperSession);
  EXPECT_THAT(text, ContainsRegex("O1, axis 0° +-0\\.834465 +1\\.035996 +401\\.954078 +17 +14"));
  EXPECT_THAT(text, ContainsRegex("O2, axis 180° +-1\\.482783 +-1\\.579641 +403\\.913821 +17 +14"));
  EXPECT_THAT(text, ContainsRegex("Δd, fit only = 1\\.307818 mm ± 0\\.2[0-9]+ mm \\(95 % coverage"));
  EXPECT_THAT(text,
              ContainsRegex("Correlation of the radius with x and y: at 0° 0\\.00 and -0\\.48; at 180°"));
  EXPECT_THAT(
      text, ContainsRegex(
                "Verdict: accept\\. Δd = 1\\.[0-9]+ mm ± 0\\.[0-9]+ mm \\(95 % coverage\\), all effects\\s"));
  EXPECT_THAT(text, HasSubstr("  Reference 2 mm: difference −0.9"));
}

// Δd is 0.40 mm.
TEST(FitText, TellsTheMeasuredResultFirstAndThatOfTheFitBelow) {
  const std::string two = textOf(ALIDADE_SAMPLES_DIR "/two-causes.alidade");
  EXPECT_THAT(two, ContainsRegex("^[^\n]+\nΔd = 0\\.4[0-9]* ± 0\\.[01][0-9]* mm \\(95 % coverage\\)   "
                                 "UNDECIDED   tolerance ± 0\\.5 mm\n0 =+\\[[^\n]+:[^\n]*  0\\.5 mm\n"))
      << "right below the name of the session";
  EXPECT_THAT(two, ContainsRegex("\nΔd, fit only = 0\\.38[0-9]* mm ± 0\\.0[0-9]+ mm "));
  EXPECT_THAT(two, ContainsRegex("  arc ellipticity +0\\.05 mm +B +0\\.01[0-9]* +[0-9.]+ % +default"));
  EXPECT_THAT(two, HasSubstr("\nGap: The gap is best explained by several causes together: "));
  EXPECT_THAT(textOf(ALIDADE_SAMPLES_DIR "/noisy-readings.alidade"), Not(HasSubstr("\nGap: ")))
      << "noise alone";
}

TEST(FitText, SaysPlainlyThatNoDiagnosisWasMade) {
  const ProgramRun run = alidadeCli({"fit", "--no-diagnosis", paperSession});
  EXPECT_THAT(run.out, HasSubstr("\nΔd: no diagnosis was made   Accepted, fit only   tolerance ± 2.5 mm\n"));
}

TEST(FitText, GivesTheBudgetAndTheFindings) {
  const std::string text = textOf(paperSession);
  EXPECT_THAT(text, ContainsRegex("  readings +0\\.102 +[0-9.]+ %"));
  EXPECT_THAT(text, ContainsRegex("  pointing zeros +0\\.0"));
  EXPECT_THAT(text, ContainsRegex("  distance +0\\.0"));
  EXPECT_THAT(text, HasSubstr("\nFindings\n"));
  EXPECT_THAT(text, HasSubstr("Readings scatter 6.91 times as much as stated"));
}

TEST(FitText, ShowsThePublishedMethodAsItWasPrinted) {
  const std::string text = textOf(paperSession, "published");
  EXPECT_THAT(text, ContainsRegex("O1, axis 0° +-0\\.0091 +-0\\.97[12][0-9] +1\\.8143 +0\\.0283"));
  EXPECT_THAT(text, ContainsRegex("O2, axis 180° +-0\\.0318 +-1\\.49[12][0-9] +-2\\.0538 +-0\\.0360"));
  EXPECT_THAT(text, HasSubstr("in the paper's signs 1.934"));
  EXPECT_THAT(text, HasSubstr("states no uncertainty"));
  EXPECT_THAT(text, Not(HasSubstr("Verdict")));
}

TEST(FitText, LinesUpItsColumns) {
  const std::string text = textOf(paperSession);
  const std::regex decimals("(O[12], axis.*)\\.[0-9]{6} ");
  std::vector<std::size_t> ends;
  for (std::sregex_iterator row(text.begin(), text.end(), decimals), none; row != none; ++row) {
    ends.push_back(static_cast<std::size_t>(row->length()));
  }
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0], ends[1]);
}

TEST(FitText, SaysThatNoVerdictIsDrawnWithoutATolerance) {
  const TemporaryFolder folder;
  const std::string text = textOf(
      folder.file("s.alidade",
                  changedPaperSession([](nlohmann::ordered_json& session) { session.erase("acceptance"); })));
  EXPECT_THAT(text, HasSubstr("Verdict: none. No tolerance stated"));
  EXPECT_THAT(text, Not(HasSubstr("was set to")));
}

TEST(FitText, TellsOneArcWithoutAnIntersection) {
  const TemporaryFolder folder;
  const std::string text = textOf(folder.file(
      "s.alidade",
      changedPaperSession([](nlohmann::ordered_json& session) { session["positions"].erase(0); })));
  EXPECT_THAT(text, HasSubstr("O2, axis 180°"));
  EXPECT_THAT(text, Not(HasSubstr("O1, axis")));
  EXPECT_THAT(text, Not(HasSubstr("Δd, ")));
  EXPECT_THAT(text, HasSubstr("0°, so no intersection."));
}

TEST(FitText, GivesTheTwoFaceTableWhereThereAreTwoFaces) {
  EXPECT_THAT(textOf(paperSession), Not(HasSubstr("Both faces")));
  const std::string text = textOf(std::string(ALIDADE_REFERENCE_DIR) + "/trials/sessions/241926.alidade");
  EXPECT_THAT(text, ContainsRegex("Both faces +round +point +elevation"));
  EXPECT_THAT(text, ContainsRegex("collimation c +-[0-9.]+ +0\\.[0-9]+"));
  EXPECT_THAT(text, ContainsRegex("2c scatters [0-9.]+ times as much as stated"));
}

}  // namespace
}  // namespace alidade::test
