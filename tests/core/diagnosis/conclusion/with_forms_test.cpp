#include "core/diagnosis/conclusion/with_forms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/diagnosis/diagnose.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

using Kind = ForeignEffect::Kind;

constexpr double arcsec = Angle::fromArcseconds(1).radians();

struct Spoilt {
  const char* name;
  Truth truth;
};

Truth foreign(Kind kind, double size, double first, double second, std::uint64_t seed) {
  Truth truth = drawTruth(seed);
  truth.foreign = ForeignEffect{kind, size, first, second};
  return truth;
}

/// Sessions with uncatalogued effects; the last two also have a catalogued effect.
std::vector<Spoilt> spoiltSessions() {
  std::vector<Spoilt> all{{"dent", foreign(Kind::LocalDent, -0.5, 70, 11, 5)},
                          {"settling", foreign(Kind::Settling, 40, 0.15, 0, 6)},
                          {"harmonic", drawTruth(11)},
                          {"warp", foreign(Kind::HighWarp, 0.6, 5, 30, 9)},
                          {"refraction and trunnion tilt", foreign(Kind::LocalDent, 0.4, 110, 9, 7)},
                          {"circle and eccentricity", foreign(Kind::CirclePeriods, 25, 7, 50, 4)}};
  all[2].truth.harmonic = FormHarmonic{.order = 5, .cosine = 0.2, .sine = 0.15};
  all[4].truth.effects = {{ErrorTerm::TrunnionTilt, 90 * arcsec}};
  all[5].truth.effects = {{ErrorTerm::HorizontalCircleSine, 40 * arcsec}};
  return all;
}

Diagnosis diagnosisOf(const Truth& truth, std::uint64_t seed) {
  return *diagnose(*examine(*simulate(*protocolByName("full"), truth, seed)).measurement);
}

// With 2″ of noise, 272 readings minus some twenty unknowns have an rms of 1.6 … 2.2″ in 99.9 % of cases.
TEST(WithForms, ShrinkTheGapToItsNoise) {
  for (const auto& [name, truth] : spoiltSessions()) {
    const Diagnosis diagnosis = diagnosisOf(truth, 12);
    ASSERT_FALSE(diagnosis.steps.empty()) << name;
    EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::NotInCatalogue) << name;
    EXPECT_EQ(diagnosis.steps.back().effect, formId) << name;
    EXPECT_GT(diagnosis.gap.rms, 2.6) << name;
    EXPECT_LT(diagnosis.steps.back().size.rms, 2.2) << name;
    EXPECT_GT(diagnosis.steps.back().size.rms, 1.6) << name;
    EXPECT_EQ(diagnosis.after.rms, diagnosis.steps.back().size.rms) << name;
    // The shrinkage is that of the closed model; in the session's own model, the closures absorb less.
    EXPECT_NEAR(diagnosis.shrink.inSample, 1 - diagnosis.after.rms / diagnosis.gap.rms, 0.1) << name;
    EXPECT_EQ(diagnosis.shrink.heldOut, diagnosis.forms.front().shrink.heldOut) << name;
  }
}

// The tolerance is 3 σ. One of twelve sessions exceeds it with a probability of 3 %.
TEST(WithForms, LeaveTheIntersectionRight) {
  for (const auto& [name, truth] : spoiltSessions()) {
    const Diagnosis diagnosis = diagnosisOf(truth, 21);
    const IntersectionEstimate &after = *diagnosis.afterwards, &measured = diagnosis.measured->estimate;
    EXPECT_NEAR(after.value, truth.intersection, 3 * after.sigma) << name;
    EXPECT_NEAR(measured.value, truth.intersection, 3 * measured.sigma) << name;
    EXPECT_LT(after.sigma, measured.sigma) << name << ": no effect may be there besides";
    EXPECT_LT(measured.sigma, 0.06) << name << ": every effect at its plausible size brings 0.04 mm";
  }
}

// If the form belongs to a circle or to time, the pointing zeros contain the form, too.
TEST(WithForms, TakeThePatternOffTheZeros) {
  const Truth truth = foreign(Kind::Settling, 60, 0.3, 0, 8);
  Session session = *simulate(*protocolByName("full"), truth, 8);
  const Measurement measurement = *examine(session).measurement;
  const SessionFit fit = fitSession(measurement);
  const Inquiry inquiry = inquire(*modelOf(measurement, fit), {}, {});
  const auto readings = inquiry.leftover.readings();
  // A constant in all horizontal readings, including zeros, only turns the orientation: rows relative to
  // their zeros do not change.
  Eigen::VectorXd even(readings);
  for (Eigen::Index i = 0; i < readings; ++i) {
    const LinearReading& reading = inquiry.leftover.reading(i);
    even[i] = reading.kind == ReadingKind::Horizontal ? 10 * arcsec / reading.sigma : 0;
  }
  const Measurement then = withoutPattern(measurement, inquiry, even);
  for (std::size_t arc = 0; arc < then.arcs.size(); ++arc)
    for (std::size_t row = 0; row < then.arcs[arc].sightings.size(); ++row)
      EXPECT_NEAR((then.arcs[arc].sightings[row].a - measurement.arcs[arc].sightings[row].a).arcseconds(), 0,
                  1e-6);
}

TEST(WithForms, AreNoneWithoutAGap) {
  const Diagnosis diagnosis = diagnosisOf(drawTruth(3), 3);
  for (const GapStep& step : diagnosis.steps) EXPECT_NE(step.effect, formId);
}

}  // namespace
}  // namespace alidade
