#include "core/wording/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "core/base/number_text.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::AllOf, testing::HasSubstr;

TEST(VerdictSentence, StatesTheNumbersItRestsOn) {
  EXPECT_EQ(
      verdictSentence(1.30764, 0.2117, 2.5, 0.95),
      "Δd = 1.31 mm ± 0.21 mm (95 % coverage) from the fit only; the interval is within the tolerance of "
      "± 2.5 mm.");
  EXPECT_THAT(verdictSentence(1, 0.01, 0.5, 0.95), HasSubstr("is outside"));
  EXPECT_THAT(verdictSentence(1, 0.01, 1, 0.95), HasSubstr("neither wholly within nor wholly outside"));
}

// In an earlier version, "1.31 mm ± 0.21 mm" within ± 1.519 mm contradicted itself.
TEST(VerdictSentence, RoundsSoThatItDoesNotContradictItself) {
  EXPECT_THAT(verdictSentence(1.3076, 0.2111, 1.519, 0.95),
              AllOf(HasSubstr("1.308 mm ± 0.211 mm"), HasSubstr("is within")));
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 10'000; ++i) {
    const double expanded = std::pow(10, -4 * share(generator)), value = 4 * share(generator) - 2;
    // The tolerance has as many digits as a person would type.
    const double sum = std::abs(value) + expanded * (1 + 1e-2 * (share(generator) - 0.5));
    const double tolerance = std::round(sum * 1e5) / 1e5;
    const int decimals = decimalsToDecide(value, expanded, tolerance);
    EXPECT_GE(decimals, decimalsFor(expanded));
    // The check uses the printed numbers, which a double represents to far less than a nanometre.
    const double printed =
        std::abs(std::stod(fixedText(value, decimals))) + std::stod(fixedText(expanded, decimals));
    EXPECT_EQ(printed <= tolerance + 1e-12, decide(value, expanded, tolerance) == Verdict::Accept)
        << value << " " << expanded << " " << tolerance;
  }
}

/// The sentence for the session's own model and, if there is one, a diagnosis.
std::string sentenceOf(const Measurement& measurement, const SessionFit& fit,
                       const Diagnosis* diagnosis = nullptr) {
  return verdictSentence(measurement, fit, diagnosis, *decideAcceptance(measurement, fit, diagnosis));
}

TEST(VerdictSentence, IsThatOfTheFit) {
  Measurement measurement = test::paperMeasurement();
  measurement.tolerance = 2.5;
  const SessionFit fit = fitSession(measurement);
  EXPECT_EQ(sentenceOf(measurement, fit),
            verdictSentence(fit.intersection->value, fit.intersection->expanded, 2.5, measurement.coverage) +
                " Probability of conformity: more than 99.9 %.");
}

TEST(VerdictSentence, PutsBothAccountsSideBySide) {
  Measurement measurement = test::paperMeasurement();
  measurement.tolerance = 1.6;
  const SessionFit fit = fitSession(measurement);
  Diagnosis diagnosis;
  diagnosis.verdict = DiagnosisVerdict::SingleCause;
  diagnosis.causes.emplace_back().effect = "gravity_sag";
  diagnosis.measured.emplace().estimate = {
      1.9, 0.1, 0.2, {{1, 1.9, 0.1}}, std::numeric_limits<double>::infinity()};
  diagnosis.measured->budget = {{.from = UncertaintyShare::From::Diagnosis, .sigma = 0.1}};
  EXPECT_EQ(sentenceOf(measurement, fit, &diagnosis),
            "Δd = 1.90 mm ± 0.20 mm (95 % coverage), all effects considered, is outside the tolerance of ± "
            "1.6 mm; Δd from the fit only, 1.31 mm ± 0.21 mm, is within it. Add the effects found to the "
            "model, or measure what the diagnosis advises. Probability of conformity: 0.1 %.");
  diagnosis.measured->estimate.value = 1.3;
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis),
              HasSubstr(". Both intervals are within the tolerance of ± 1.6 mm."));
  diagnosis.measured->estimate.value = 1.5;
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis),
              HasSubstr("all effects considered, is not clearly within or outside the tolerance"));
  diagnosis.measured->budget = {
      {.effect = "plane_warp", .from = UncertaintyShare::From::Default, .sigma = 0.1}};
  EXPECT_THAT(
      sentenceOf(measurement, fit, &diagnosis),
      HasSubstr("Most of U comes from plane warp at its plausible size: take readings that show it."));
  diagnosis.attainable = {{.expanded = 0.2},
                          {.known = "plane_warp", .expanded = 0.05},
                          {.measures = {Measure::BothFaces, Measure::WayBack}, .expanded = 0.1},
                          {.measures = {Measure::SliderReadings}, .expanded = 0.15}};
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis),
              HasSubstr("at its plausible size: with slider readings, U would be about 0.15 mm."));
  diagnosis.measured.reset();
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis), HasSubstr("these readings do not determine Δd."));
}

TEST(VerdictSentence, NamesWhatItIsAbout) {
  Measurement measurement = test::paperMeasurement();
  measurement.tolerance = 2.6;
  const SessionFit fit = fitSession(measurement);
  Diagnosis diagnosis;
  diagnosis.measured.emplace().estimate = {
      1.3, 0.1, 0.2, {{1, 1.3, 0.1}}, std::numeric_limits<double>::infinity()};
  diagnosis.measured->budget = {{.from = UncertaintyShare::From::Diagnosis, .sigma = 0.1}};
  measurement.measurand = Measurand::Distance;
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis),
              HasSubstr("its part perpendicular to the plane of the arc was not measured"));
  diagnosis.measured->across = MeasuredLength{-2, 0.1, 0.2};
  diagnosis.measured->distance = MeasuredLength{2.386, 0.1, 0.2};
  EXPECT_THAT(
      sentenceOf(measurement, fit, &diagnosis),
      HasSubstr(
          "The arc's centre is 2.39 mm ± 0.20 mm (95 % coverage) from the axis, all effects considered: "
          "1.30 mm ± 0.20 mm in the plane of the arc (Δd), −2.00 mm ± 0.20 mm perpendicular to it (Δz). The "
          "interval is within the tolerance of 2.6 mm."));
  measurement.measurand = Measurand::Intersection;
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis),
              HasSubstr("The verdict covers only the plane of the arc; perpendicular to it, the arc's centre "
                        "is 2.00 mm ± 0.20 mm from the "
                        "axis."));
}

TEST(VerdictSentence, AsksForACoverage) {
  Measurement measurement = test::paperMeasurement();
  measurement.tolerance = 2.5;
  measurement.coverage = 0.5;
  EXPECT_EQ(sentenceOf(measurement, fitSession(measurement)),
            "There is no verdict at a coverage of 50 %: state a coverage of 0.9 or more.");
}

TEST(VerdictSentence, SaysWhyItIsWithheld) {
  Measurement measurement = test::paperMeasurement();
  measurement.tolerance = 2.5;
  SessionFit fit = fitSession(measurement);
  fit.lengthsInDoubt = LengthsInDoubt{.distance = 2.405, .nominalRadius = 400};
  EXPECT_EQ(sentenceOf(measurement, fit),
            "The verdict is withheld: no theodolite sights anything at a distance of 2.405 mm. Check the "
            "distance L (2.405) and the nominal radius R0 (400), both in mm.");
  fit.lengthsInDoubt =
      LengthsInDoubt{.distance = 2405, .nominalRadius = 200, .radius = LengthsInDoubt::Radius{180, 99.6}};
  EXPECT_THAT(sentenceOf(measurement, fit),
              HasSubstr("withheld: the radius fitted at 180° differs from the nominal one by 100 %"));
}

TEST(ProbabilityText, ClaimsNoCertainty) {
  EXPECT_EQ(probabilityText(0.973), "97.3 %");
  EXPECT_EQ(probabilityText(1), "more than 99.9 %");
  EXPECT_EQ(probabilityText(0), "less than 0.1 %");
  EXPECT_EQ(shortProbabilityText(0.973), "97 %");
  EXPECT_EQ(shortProbabilityText(0.993), "99.3 %");
  EXPECT_EQ(shortProbabilityText(1), "> 99.9 %");
  EXPECT_EQ(shortProbabilityText(0), "< 0.1 %");
}

}  // namespace
}  // namespace alidade
