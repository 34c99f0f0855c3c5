#include "core/wording/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::HasSubstr;

TEST(VerdictSentence, StatesTheNumbersItRestsOn) {
  EXPECT_EQ(verdictSentence(1.30764, 0.2117, 2.5, 0.95),
            "By the fit alone, the intersection is 1.31 mm ± 0.21 mm (95 % coverage); it lies within the "
            "tolerance of "
            "± 2.5 mm, its uncertainty included.");
  EXPECT_THAT(verdictSentence(1, 0.01, 0.5, 0.95), HasSubstr("lies outside"));
  EXPECT_THAT(verdictSentence(1, 0.01, 1, 0.95), HasSubstr("cannot be said"));
}

/// Of what the session's own model and, where there is one, a diagnosis say.
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
                " It conforms with a probability of more than 99.9 %.");
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
  EXPECT_EQ(
      sentenceOf(measurement, fit, &diagnosis),
      "By the fit alone, the intersection is 1.31 mm ± 0.21 mm, within the tolerance of ± 1.6 mm; with all "
      "that these readings leave possible, it is 1.90 mm ± 0.20 mm (95 % coverage), outside it. Add to the "
      "model what was found, or measure what the diagnosis advises. By all that is possible, it conforms "
      "with a probability of 0.1 %.");
  diagnosis.measured->estimate.value = 1.3;
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis),
              HasSubstr("; both lie within the tolerance of ± 1.6 mm, their uncertainty included."));
  diagnosis.measured->estimate.value = 1.5;
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis),
              HasSubstr("(95 % coverage), not clearly within or outside it."));
  diagnosis.measured->budget = {
      {.effect = "plane_warp", .from = UncertaintyShare::From::Default, .sigma = 0.1}};
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis), HasSubstr("The most of U comes from plane_warp"));
  diagnosis.measured.reset();
  EXPECT_THAT(sentenceOf(measurement, fit, &diagnosis), HasSubstr("these readings do not determine it."));
}

TEST(VerdictSentence, AsksForACoverage) {
  Measurement measurement = test::paperMeasurement();
  measurement.tolerance = 2.5;
  measurement.coverage = 0.5;
  EXPECT_EQ(sentenceOf(measurement, fitSession(measurement)),
            "There is no verdict at a coverage of 50 %: state acceptance.coverage as 0.9 or more.");
}

TEST(VerdictSentence, SaysWhyItIsWithheld) {
  Measurement measurement = test::paperMeasurement();
  measurement.tolerance = 2.5;
  SessionFit fit = fitSession(measurement);
  fit.lengthsInDoubt = LengthsInDoubt{.distance = 2.405, .nominalRadius = 400};
  EXPECT_EQ(sentenceOf(measurement, fit),
            "The verdict is withheld: no theodolite sights anything at a distance of 2.405 mm: check the "
            "distance L (geometry.distance_mm: 2.405) and the nominal radius R0 (geometry.radius_mm: 400), "
            "both in mm.");
  fit.lengthsInDoubt =
      LengthsInDoubt{.distance = 2405, .nominalRadius = 200, .radius = LengthsInDoubt::Radius{180, 99.6}};
  EXPECT_THAT(sentenceOf(measurement, fit),
              HasSubstr("withheld: the radius fitted at 180° is 100 % off the nominal one"));
}

TEST(ProbabilityText, ClaimsNoCertainty) {
  EXPECT_EQ(probabilityText(0.973), "97.3 %");
  EXPECT_EQ(probabilityText(1), "more than 99.9 %");
  EXPECT_EQ(probabilityText(0), "less than 0.1 %");
}

}  // namespace
}  // namespace alidade
