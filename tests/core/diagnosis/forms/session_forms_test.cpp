#include "core/diagnosis/forms/session_forms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/diagnosis/diagnose.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using Kind = ForeignEffect::Kind;

Diagnosis diagnosisOf(const Truth& truth, std::uint64_t seed, const char* protocol = "full") {
  return *diagnose(*examine(*simulate(*protocolByName(protocol), truth, seed)).measurement);
}

const FormNumber& parameter(const FoundForm& found, const std::string& name) {
  return *std::ranges::find(found.parameters, name, &FormNumber::name);
}

void expectWithin3u(const FoundForm& found, const std::string& name, double truth) {
  const FormNumber& number = parameter(found, name);
  EXPECT_NEAR(number.value, truth, 3 * number.sigma + 1e-9) << name;
  EXPECT_LT(number.sigma, std::max(0.5 * std::abs(truth), 1e-9)) << name;
}

TEST(SessionForms, FindAHarmonicWithItsOrder) {
  for (const int order : {4, 7}) {
    Truth truth = drawTruth(11);
    truth.harmonic = FormHarmonic{.order = order, .cosine = 0.2, .sine = 0.15};
    const Diagnosis diagnosis = diagnosisOf(truth, 11);
    EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::NotInCatalogue);
    ASSERT_EQ(diagnosis.forms.size(), 1U) << order;
    const FoundForm& found = diagnosis.forms.front();
    EXPECT_EQ(found.form.carrier, FormCarrier::Radial);
    EXPECT_EQ(found.form.function, FormFunction::Harmonic);
    EXPECT_EQ(found.form.order, order);
    EXPECT_EQ(found.formula,
              "radial = A*cos(" + std::to_string(order) + "*s) + B*sin(" + std::to_string(order) + "*s)");
    EXPECT_GT(found.probability, 0.5);
    expectWithin3u(found, "amplitude_mm", 0.25);
    EXPECT_GT(found.shrink.heldOut, 0.6);
    EXPECT_NEAR(found.shrink.heldOut, found.shrink.inSample, 0.1);
    EXPECT_GT(found.shrink.f, 100);
    EXPECT_LT(found.shrink.p, 1e-9);
    EXPECT_EQ(found.shrink.heldOutReadings, 272) << "two circles of 136 rows";
  }
}

TEST(SessionForms, FindADentWithItsPlaceAndWidth) {
  for (const char* protocol : {"full", "paper-slider"}) {
    Truth truth = drawTruth(5);
    truth.foreign = ForeignEffect{Kind::LocalDent, -0.5, 70, 11};
    const Diagnosis diagnosis = diagnosisOf(truth, 5, protocol);
    ASSERT_FALSE(diagnosis.forms.empty()) << protocol;
    const FoundForm& found = diagnosis.forms.front();
    EXPECT_EQ(found.form.carrier, FormCarrier::Radial);
    EXPECT_EQ(found.form.function, FormFunction::Bump);
    expectWithin3u(found, "at_deg", 70);
    expectWithin3u(found, "width_deg", 11);
    expectWithin3u(found, "amplitude_mm", -0.5);
    EXPECT_GT(found.shrink.heldOut, 0.4) << protocol;
  }
}

// Without its fifth row, a random walk of 24 numbers absorbs nearly all of Table I, but predicts held-out
// readings three times worse than no form. Every reported form must predict.
TEST(SessionForms, TellSomethingOfReadingsThatTookNoPart) {
  for (std::size_t row = 0; row < 17; ++row) {
    Session session = test::paperSession();
    std::vector<Reading>& readings = session.positions[0].readings;
    readings.erase(readings.begin() + static_cast<std::ptrdiff_t>(row));
    const Diagnosis diagnosis = *diagnose(test::measurementOf(session));
    for (const FoundForm& found : diagnosis.forms)
      EXPECT_TRUE(found.shrink.heldOut > 0 || found.shrink.p < 0.05) << row << ": " << found.formula;
  }
}

TEST(SessionForms, FindAWarp) {
  Truth truth = drawTruth(9);
  truth.foreign = ForeignEffect{Kind::HighWarp, 0.9, 4, 30};
  const Diagnosis diagnosis = diagnosisOf(truth, 9);
  ASSERT_FALSE(diagnosis.forms.empty());
  EXPECT_EQ(diagnosis.forms.front().form.carrier, FormCarrier::Across);
  EXPECT_EQ(diagnosis.forms.front().form.order, 4);
  expectWithin3u(diagnosis.forms.front(), "amplitude_mm", 0.9);
}

// Over 19° of the circle, neighbouring orders of equal parity are look-alikes; the true one is listed.
TEST(SessionForms, TellWhichOrdersOfACircleLookAlike) {
  Truth truth = drawTruth(4);
  truth.foreign = ForeignEffect{Kind::CirclePeriods, 40, 7, 50};
  const Diagnosis diagnosis = diagnosisOf(truth, 4);
  ASSERT_FALSE(diagnosis.forms.empty());
  const FoundForm& found = diagnosis.forms.front();
  EXPECT_EQ(found.form.of, FormArgument::HorizontalCircle);
  const auto isSeventh = [](const Form& form) {
    return form.of == FormArgument::HorizontalCircle && form.order == 7;
  };
  EXPECT_TRUE(isSeventh(found.form) ||
              std::ranges::any_of(found.indistinguishableFrom,
                                  [&](const FormLookAlike& other) { return isSeventh(other.form); }));
  EXPECT_GT(parameter(found, "order").sigma, 0.1);
}

TEST(SessionForms, AreNoneInCleanSessions) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const char* protocol : {"paper", "two-face"})
      EXPECT_TRUE(diagnosisOf(drawTruth(seed), seed, protocol).forms.empty()) << protocol << seed;
}

// If the diagnosis may not consider an ellipticity, it reports a second harmonic as a form.
TEST(SessionForms, TakeThePlaceOfAnEffectThatIsLeftOut) {
  Truth truth = drawTruth(6);
  truth.effects = {{ErrorTerm::EllipticityCosine, 0.4}, {ErrorTerm::EllipticitySine, 0.2}};
  const Measurement measurement = *examine(*simulate(*protocolByName("full"), truth, 6)).measurement;
  const Diagnosis diagnosis = *diagnose(measurement, {.without = {"arc_ellipticity"}});
  ASSERT_EQ(diagnosis.verdict, DiagnosisVerdict::NotInCatalogue) << "or it would prove nothing";
  ASSERT_FALSE(diagnosis.forms.empty());
  EXPECT_EQ(diagnosis.forms.front().form.carrier, FormCarrier::Radial);
  EXPECT_EQ(diagnosis.forms.front().form.order, 2);
}

}  // namespace
}  // namespace alidade
