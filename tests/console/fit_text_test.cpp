#include <gmock/gmock.h>

#include <algorithm>
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

/// The number of code points of a UTF-8 text.
std::size_t lettersIn(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

TEST(FitText, TellsCentresRadiiAndIntersectionOfThePapersReadings) {
  const std::string text = textOf(paperSession);
  EXPECT_THAT(
      text,
      ContainsRegex("O1 at 0° +−0\\.834 \\(0\\.063\\) +1\\.036 \\(0\\.[0-9]+\\) +401\\.954 .* 17 .* 14\n"));
  EXPECT_THAT(text,
              ContainsRegex(
                  "O2 at 180° +−1\\.483 \\(0\\.063\\) +−1\\.580 \\(0\\.[0-9]+\\) +403\\.914 .* 17 .* 14\n"));
  EXPECT_THAT(
      text,
      ContainsRegex(
          "Δd,\\sfit\\sonly:\\s1\\.31\\s±\\s0\\.21\\smm,\\sk\\s=\\s2\\.[0-9]+,\\su\\s=\\s0\\.10[0-9]*\\smm"));
  EXPECT_THAT(text, ContainsRegex("correlation with R +0\\.00 +−0\\.48"));
  EXPECT_THAT(
      text, ContainsRegex(
                "Verdict: accept\\. Δd = 1\\.[0-9]+ mm ± 0\\.[0-9]+ mm \\(95 % coverage\\), all effects\\s"));
  EXPECT_THAT(text, HasSubstr("  Reference 2 mm: difference −0.7"));
}

// The true Δd is 0.40 mm.
TEST(FitText, TellsTheMeasuredResultFirstAndThatOfTheFitBelow) {
  const std::string two = textOf(ALIDADE_SAMPLES_DIR "/two-causes.alidade");
  EXPECT_THAT(two, ContainsRegex("^[^\n]+\nΔd = 0\\.4[0-9]* ± 0\\.[01][0-9]* mm \\(95 % coverage\\)   "
                                 "UNDECIDED   tolerance ± 0\\.5 mm\n0 =+\\[[^\n]+:[^\n]*  0\\.5 mm\n"))
      << "right below the name of the session";
  EXPECT_THAT(two, ContainsRegex("Δd,\\sfit\\sonly:\\s0\\.38[0-9]*\\s±\\s0\\.0[0-9]+\\smm,\\sk"));
  EXPECT_THAT(two,
              ContainsRegex("  arc ellipticity +0\\.05 mm +B +0\\.[0-9]+ +0\\.01[0-9]* +[0-9.]+ % +default"));
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
  EXPECT_THAT(text, ContainsRegex("  readings +[0-9]+ +0\\.102 +[0-9.]+ %"));
  EXPECT_THAT(text, ContainsRegex("  pointing zeros +∞ +0\\.0"));
  EXPECT_THAT(text, ContainsRegex("  distance +∞ +0\\.0"));
  EXPECT_THAT(text, HasSubstr("\nFindings\n"));
  EXPECT_THAT(text, HasSubstr("scaled by their scatter, 6.91 times the stated noise"));
}

TEST(FitText, ShowsThePublishedMethodAsItWasPrinted) {
  const std::string text = textOf(paperSession, "published");
  EXPECT_THAT(text, ContainsRegex("O1 at 0° +−0\\.97[12][0-9] +1\\.8143 +−0\\.0091 +0\\.0283"));
  EXPECT_THAT(text, ContainsRegex("O2 at 180° +−1\\.49[12][0-9] +−2\\.0538 +−0\\.0318 +−0\\.0360"));
  EXPECT_THAT(text, HasSubstr("Δd as printed = 1.934"));
  EXPECT_THAT(text, HasSubstr("states no uncertainty"));
  EXPECT_THAT(text, Not(HasSubstr("Verdict")));
}

TEST(FitText, LinesUpItsColumns) {
  const std::string text = textOf(paperSession);
  const std::regex rows("\n  (O[12] at [0-9]+° .*)");
  std::vector<std::size_t> ends;
  for (std::sregex_iterator row(text.begin(), text.end(), rows), none; row != none; ++row)
    ends.push_back(lettersIn((*row)[1].str()));
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0], ends[1]);
}

TEST(FitText, SaysThatNoVerdictIsDrawnWithoutATolerance) {
  const TemporaryFolder folder;
  const std::string text = textOf(
      folder.file("s.alidade",
                  changedPaperSession([](nlohmann::ordered_json& session) { session.erase("acceptance"); })));
  EXPECT_THAT(text, HasSubstr("Verdict: none. No tolerance is stated"));
}

TEST(FitText, TellsOneArcWithoutAnIntersection) {
  const TemporaryFolder folder;
  const std::string text = textOf(folder.file(
      "s.alidade",
      changedPaperSession([](nlohmann::ordered_json& session) { session["positions"].erase(0); })));
  EXPECT_THAT(text, HasSubstr("O2 at 180°"));
  EXPECT_THAT(text, Not(HasSubstr("O1 at")));
  EXPECT_THAT(text, Not(HasSubstr("Δd, fit only")));
  EXPECT_THAT(text, HasSubstr("0°, so the intersection cannot be computed."));
}

TEST(FitText, GivesTheTwoFaceTableWhereThereAreTwoFaces) {
  EXPECT_THAT(textOf(paperSession), Not(HasSubstr("Both faces")));
  const std::string text = textOf(std::string(ALIDADE_REFERENCE_DIR) + "/trials/sessions/241926.alidade");
  EXPECT_THAT(text, ContainsRegex("Both faces +Round +Point +Elevation"));
  EXPECT_THAT(text, ContainsRegex("collimation c +−[0-9.]+ \\(0\\.[0-9]+\\) +× [0-9.]+"));
}

}  // namespace
}  // namespace alidade::test
