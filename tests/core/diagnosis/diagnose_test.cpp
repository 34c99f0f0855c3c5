#include "core/diagnosis/diagnose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/gap/leftover.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/session/session_file.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

Diagnosis diagnosed(const Measurement& measurement, const DiagnosisOptions& options = {}) {
  return *diagnose(measurement, options);
}

/// The ray tracer's sessions of one kind, with the effect withheld.
std::vector<test::Trial> trialsOf(const std::string& kind) {
  std::vector<test::Trial> chosen;
  for (test::Trial& trial : test::trials())
    if (trial.kind == kind) chosen.push_back(std::move(trial));
  EXPECT_FALSE(chosen.empty()) << kind;
  return chosen;
}

TEST(Diagnosis, FindsNothingWhereThereIsNothing) {
  for (const test::Trial& trial : trialsOf("none")) {
    const Diagnosis diagnosis = diagnosed(trial.measurement);
    EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::WithinNoise) << trial.id;
    EXPECT_THAT(diagnosis.causes, IsEmpty()) << trial.id;
    EXPECT_EQ(diagnosis.shrink.inSample, 0) << trial.id;
    EXPECT_EQ(diagnosis.afterwards->value, diagnosis.before->value) << trial.id;
  }
}

// An arc from 20° to 200° continues beyond half a turn, and so do its slider readings.
TEST(Diagnosis, NamesTheScaleOfASliderBeyondHalfATurn) {
  Protocol protocol = *protocolByName("full");
  protocol.first = Angle::fromDegrees(20);
  protocol.step = Angle::fromDegrees(11.25);
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    Truth truth = drawTruth(seed);
    truth.effects = {{ErrorTerm::SliderScale, 4e-4}};
    const Diagnosis diagnosis = diagnosed(*examine(*simulate(protocol, truth, seed)).measurement);
    ASSERT_FALSE(diagnosis.causes.empty()) << seed;
    EXPECT_EQ(diagnosis.causes.front().effect, "slider_scale") << seed;
  }
}

class WithheldEffect : public testing::TestWithParam<const char*> {};

// The truth is the first cause or one of its look-alikes. With the cause in the model only noise remains (0.1
// % point). Δd is right within three expanded uncertainties at 95 %, because one of some thirty sessions may
// exceed one.
TEST_P(WithheldEffect, IsNamedAndRemoved) {
  constexpr double enough = 6;  // σ in the readings: less may be missed
  for (const test::Trial& trial : trialsOf(GetParam())) {
    if (trial.visibleSigma < enough) continue;
    SCOPED_TRACE(trial.id + " " + trial.protocol);
    const Diagnosis diagnosis = diagnosed(trial.measurement);
    ASSERT_FALSE(diagnosis.causes.empty());
    const Cause& first = diagnosis.causes.front();
    std::vector<std::string> named = first.indistinguishableFrom;
    named.push_back(first.effect);
    EXPECT_THAT(named, Contains(trial.kind));
    EXPECT_GT(diagnosis.after.pValue, 0.001);
    EXPECT_LT(diagnosis.after.rms, diagnosis.gap.rms);
    EXPECT_GT(diagnosis.shrink.ofExcess, 0.5);
    EXPECT_NEAR(diagnosis.afterwards->value, trial.intersection, 3 * diagnosis.afterwards->expanded);
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, WithheldEffect,
                         testing::Values("collimation", "trunnion_tilt", "vertical_index",
                                         "vertical_axis_tilt", "horizontal_circle_eccentricity",
                                         "vertical_circle_eccentricity", "horizontal_drift", "vertical_drift",
                                         "plane_tilt", "arc_ellipticity", "arc_lobing", "gravity_sag",
                                         "plane_warp", "slider_scale", "slider_eccentricity",
                                         "vertical_angle_relation", "orientation_jump"));

TEST(Diagnosis, NamesTheVeryReadingsThatAreMisread) {
  for (const test::Trial& trial : trialsOf("gross_error")) {
    const Diagnosis diagnosis = diagnosed(trial.measurement);
    ASSERT_EQ(diagnosis.causes.size(), 1u) << trial.id;
    EXPECT_EQ(diagnosis.causes[0].effect, "gross_error");
    std::set<std::tuple<int, int, int, int, bool>> truth, named;
    for (const auto& grossError : trial.truth.at("blunders"))
      truth.emplace(grossError[0] == 0 ? 0 : 180, grossError[1], grossError[2], grossError[3],
                    grossError[4] != 0);
    for (const ReadingDeviation& reading : diagnosis.causes[0].readings)
      named.emplace(reading.axisDeg, reading.round, reading.point, reading.face,
                    reading.kind == ReadingKind::Horizontal);
    EXPECT_EQ(named, truth) << trial.id;
  }
}

TEST(Diagnosis, PinsNoUnknownPatternOnTheCatalogue) {
  for (const test::Trial& trial : trialsOf("unknown_harmonic")) {
    const Diagnosis diagnosis = diagnosed(trial.measurement);
    EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::NotInCatalogue) << trial.id;
    EXPECT_THAT(diagnosis.causes, IsEmpty()) << trial.id;
    ASSERT_TRUE(diagnosis.shape) << trial.id;
    EXPECT_THAT(diagnosis.shape->follows, testing::HasSubstr("radius")) << trial.id;
  }
}

// A sawtooth error of 20″ in the horizontal circle only, five to eight rows per tooth. The slow waves of a
// wandering orientation cannot distinguish it from noise.
TEST(Diagnosis, TellsAQuickWanderOfAFewRowsFromNoise) {
  for (const double teeth : {4.3, 5.3, 6.3}) {
    SCOPED_TRACE(teeth);
    Measurement measurement =
        test::measurementOf(*simulate(*protocolByName("paper-slider"), drawTruth(12), 12));
    for (ArcMeasurement& arc : measurement.arcs)
      for (Sighting& sighting : arc.sightings) {
        const double teethBefore =
            teeth * static_cast<double>(sighting.sequence) / static_cast<double>(measurement.rows);
        sighting.a = sighting.a + Angle::fromArcseconds(20) * (teethBefore - std::floor(teethBefore));
      }
    EXPECT_EQ(diagnose(measurement)->verdict, DiagnosisVerdict::NotInCatalogue);
  }
}

TEST(Diagnosis, SeesNoiseThatIsLargerThanStated) {
  for (const test::Trial& trial : trialsOf("underestimated_noise")) {
    const Diagnosis diagnosis = diagnosed(trial.measurement);
    ASSERT_EQ(diagnosis.causes.size(), 1u) << trial.id;
    EXPECT_EQ(diagnosis.causes[0].effect, "underestimated_noise") << trial.id;
    EXPECT_NEAR(diagnosis.after.reducedChiSquare, 1, 1e-9) << trial.id;  // by definition of the ratio
  }
}

// The paper's own gap: its readings follow the exact relation, but are evaluated with the published one. The
// diagnosis must find that relation. It must also find the gap of the exact fit of the table: a residual rms
// of 8.87″, seven times the stated scatter. The positions do not agree. R differs by 1.96 mm, which a plane
// offset of −5.9 mm or a change of radius would explain; Δx differs by −0.65 mm. The cause of the latter is
// unknown, and Δd depends on it: U is four times that of the fit.
TEST(Diagnosis, FindsTheGapOfThePaper) {
  Measurement measurement = test::paperMeasurement();
  const Diagnosis exact = diagnosed(measurement);
  EXPECT_NEAR(exact.gap.rms, 8.87, 0.005);
  ASSERT_EQ(exact.causes.size(), 3u);
  EXPECT_EQ(exact.causes[0].effect, "plane_offset");
  EXPECT_NEAR(exact.causes[0].parameters[0].value, -5.9, 0.2);
  EXPECT_THAT(exact.causes[0].indistinguishableFrom, testing::Contains("radius_change"));
  std::vector<std::string> closing = exact.causes[1].indistinguishableFrom;
  closing.push_back(exact.causes[1].effect);
  for (const char* id : {"axial_shift", "orientation_jump"}) EXPECT_THAT(closing, testing::Contains(id));
  // The two zeros differ by 4″ and 1″, so there was no drift of −111″ that would close Δx.
  EXPECT_THAT(closing, testing::Not(testing::Contains("horizontal_drift")));
  EXPECT_EQ(exact.causes[2].effect, "underestimated_noise");
  EXPECT_GT(exact.afterwards->expanded, 3 * exact.before->expanded);

  measurement.relation = VerticalAngleRelation::Planar;
  const Diagnosis planar = diagnosed(measurement);
  ASSERT_EQ(planar.causes.size(), 4u);
  EXPECT_EQ(planar.causes[0].effect, "vertical_angle_relation");
  EXPECT_EQ(planar.causes[1].effect, "plane_offset");
  EXPECT_EQ(planar.causes[3].effect, "underestimated_noise");
  // The share of the other relation is held to 1e-6. Accounts with a probability of one percent may differ
  // between the two diagnoses.
  EXPECT_NEAR(planar.afterwards->value, exact.afterwards->value, 0.1 * exact.afterwards->expanded);
}

// Without the right answer the verdict must not name a single wrong cause.
TEST(Diagnosis, NamesNoWrongCauseWithoutTheRightOne) {
  int wrong = 0, count = 0;
  for (const test::Trial& trial : test::trials()) {
    constexpr double enough = 6;
    if (std::isinf(trial.visibleSigma) || trial.visibleSigma < enough) continue;
    const Diagnosis diagnosis = diagnosed(trial.measurement, {.without = {trial.kind}});
    const bool single = diagnosis.causes.size() == 1;
    if (single && !trial.lookAlikes.contains(diagnosis.causes[0].effect)) ++wrong;
    ++count;
  }
  EXPECT_GE(count, 15);
  EXPECT_LE(wrong, 2);  // 3 % of some twenty sessions, and one more
}

// A candidate with evidence must explain a part of the gap, whether or not the search kept it.
TEST(Diagnosis, SaysOfEveryCandidateHowMuchOfItShows) {
  int strong = 0;
  for (const test::Trial& trial : trialsOf("two_causes"))
    for (const Candidate& candidate : diagnosed(trial.measurement).candidates) {
      if (!effectById(candidate.effect) || candidate.logBayesFactor < 10) continue;
      ++strong;
      EXPECT_GT(candidate.visibleSigma, 0) << trial.id << ' ' << candidate.effect;
    }
  EXPECT_GT(strong, 4);
}

TEST(Diagnosis, SharesAddUpToOne) {
  for (const test::Trial& trial : trialsOf("vertical_drift")) {
    std::map<std::string, double> sums;
    for (const GapShare& share : diagnosed(trial.measurement).where) sums[share.by] += share.share;
    EXPECT_EQ(sums.size(), 8u);
    for (const auto& [by, sum] : sums) EXPECT_NEAR(sum, 1, 1e-12) << by;
  }
}

TEST(Diagnosis, TellsWhatWouldSeparateLookAlikes) {
  for (const test::Trial& trial : trialsOf("plane_tilt")) {
    if (trial.protocol != "paper") continue;
    const Diagnosis diagnosis = diagnosed(trial.measurement);
    ASSERT_FALSE(diagnosis.advice.empty());
    EXPECT_FALSE(diagnosis.advice.front().ofUndetectable);
    for (const Advice& advice : diagnosis.advice) {
      if (advice.ofUndetectable) continue;
      EXPECT_GE(advice.separates.size(), 2u);
      EXPECT_GT(advice.bySigma, 4);  // limit of separation
    }
  }
}

// A jump between the pointing zero and the first visit moves an arc and leaves no trace in the readings. A
// plausible one, 60″ in any direction, is visible in two sightings of the zero, 2″ each.
TEST(Diagnosis, AdvisesToSightTheZeroAgainWhereAKnockGoesUnseen) {
  const Diagnosis diagnosis = diagnosed(test::trialMeasurement("full"));
  ASSERT_THAT(diagnosis.undetectable,
              testing::Contains(testing::Field(&UndetectableEffect::effect, "orientation_jump")));
  ASSERT_FALSE(diagnosis.advice.empty());
  const Advice& first = diagnosis.advice.front();
  EXPECT_EQ(first.measures.front(), Measure::ZeroSightedAgain);
  EXPECT_THAT(first.separates, testing::ElementsAre("orientation_jump"));
  EXPECT_TRUE(first.ofUndetectable);
  EXPECT_NEAR(first.bySigma, 60 / (2 * std::numbers::sqrt2), 1e-9);
}

// Without a cause there are no suspects to separate: advice concerns effects undetectable in one face.
TEST(Diagnosis, AdvisesOfWhatIsUnseenWhereNothingIsFound) {
  const Diagnosis diagnosis = diagnosed(test::trialMeasurement("paper"));
  ASSERT_EQ(diagnosis.verdict, DiagnosisVerdict::WithinNoise);
  EXPECT_THAT(diagnosis.advice,
              testing::Contains(testing::Field(&Advice::measures, std::vector{Measure::BothFaces})));
  for (const Advice& advice : diagnosis.advice) {
    EXPECT_TRUE(advice.ofUndetectable) << static_cast<int>(advice.measures.front());
    for (const std::string& id : advice.separates)
      EXPECT_THAT(diagnosis.undetectable, testing::Contains(testing::Field(&UndetectableEffect::effect, id)))
          << static_cast<int>(advice.measures.front());
  }
}

double memory() {  // peak memory, MB
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

// Jumps before any of the rows and patterns over all readings as plain columns would fill half a gigabyte.
TEST(Diagnosis, TakesTenThousandRows) {
  Protocol protocol = *protocolByName("full");
  protocol.rounds = 150;
  Truth truth = drawTruth(3);
  truth.effects = {{ErrorTerm::TrunnionTilt, 20}};
  const Measurement measurement = test::measurementOf(*simulate(protocol, truth, 3));
  ASSERT_GE(measurement.rows, 10000u);
  const double before = memory();
  const Diagnosis diagnosis = diagnosed(measurement);
  EXPECT_LT(memory() - before, 400);
  ASSERT_EQ(diagnosis.causes.size(), 1u);
  EXPECT_EQ(diagnosis.causes[0].effect, "trunnion_tilt");
  EXPECT_NEAR(diagnosis.causes[0].parameters[0].value, 20, 4 * diagnosis.causes[0].parameters[0].sigma);
}

TEST(Diagnosis, FailsWithTheReason) {
  const Measurement measurement = test::paperMeasurement();
  const auto unknown = diagnose(measurement, {.without = {"gremlins"}});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(std::get<UnknownCause>(unknown.problem()).id, "gremlins");
  Measurement empty = measurement;
  empty.arcs.clear();
  const auto nothing = diagnose(empty);
  ASSERT_FALSE(nothing);
  EXPECT_FALSE(std::get<NoModel>(nothing.problem()).why);
  Measurement poor = measurement;
  for (ArcMeasurement& arc : poor.arcs) arc.sightings.resize(2);
  const auto refused = diagnose(poor);
  ASSERT_FALSE(refused);
  const auto& why = std::get<NoModel>(refused.problem()).why;
  ASSERT_TRUE(why);
  EXPECT_TRUE(std::holds_alternative<session_finding::ArcMissing>(why->what));
}

// The existing fit gives the same result as a new one.
TEST(Diagnosis, TakesTheFitThatThereIs) {
  const Measurement measurement = test::trialMeasurement("full");
  const auto own = diagnose(measurement), given = diagnose(measurement, fitSession(measurement));
  ASSERT_TRUE(own && given);
  EXPECT_EQ(own->verdict, given->verdict);
  EXPECT_EQ(own->gap.rms, given->gap.rms);
  EXPECT_EQ(own->after.rms, given->after.rms);
  EXPECT_EQ(own->after.reducedChiSquare, given->after.reducedChiSquare);
  ASSERT_EQ(own->readings.size(), given->readings.size());
  for (std::size_t i = 0; i < own->readings.size(); ++i)
    EXPECT_EQ(own->readings[i].size, given->readings[i].size);
  ASSERT_TRUE(own->afterwards && given->afterwards);
  EXPECT_EQ(own->afterwards->value, given->afterwards->value);
}

// The ray tracer's own tools computed the trace of an effect in the readings, σ. Effects that our fit absorbs
// less are excluded, because it holds the distance in both positions.
TEST(Leftover, SeesAsMuchOfAnEffectAsTheRayTracer) {
  const std::map<std::string, std::pair<const char*, ErrorTerm>> terms{
      {"collimation", {"collimation", ErrorTerm::Collimation}},
      {"vertical_index", {"index", ErrorTerm::VerticalIndex}},
      {"vertical_drift", {"drift_v", ErrorTerm::VerticalDrift}},
      {"slider_eccentricity", {"slider_ecc", ErrorTerm::SliderSine}}};
  int count = 0;
  for (const test::Trial& trial : test::trials()) {
    if (!terms.contains(trial.kind)) continue;
    const auto& [name, term] = terms.at(trial.kind);
    const Leftover leftover(linearise(trial.measurement, fitSession(trial.measurement).joint));
    const double size = Angle::fromArcseconds(trial.effects.at(name).get<double>()).radians();
    const double visible = leftover.visible(leftover.column(term) * size).norm();
    EXPECT_NEAR(visible, trial.visibleSigma, 0.01 * trial.visibleSigma)
        << trial.id;  // its figures are rounded
    ++count;
  }
  EXPECT_GE(count, 4);
}

// A σ whose square or inverse square is not finite counts as zero.
TEST(Diagnosis, DoesNotHangOnHowNearToNothingASigmaIs) {
  const Session session = *loadSession(ALIDADE_SAMPLES_DIR "/paper-table-1.alidade");
  Measurement measurement = *examine(session).measurement;
  measurement.sigmaDistance = 0;
  const IntersectionEstimate exact = *diagnosed(measurement).afterwards;
  for (const double sigma : {1e-9, 1e-90, 1e-99, 1e-101, 1e-150, 1e-154, 1e-160, 1e-200, 1e-300, 5e-324}) {
    measurement.sigmaDistance = sigma;
    const IntersectionEstimate estimate = *diagnosed(measurement).afterwards;
    constexpr double rounding = 1e-9;
    EXPECT_NEAR(estimate.value, exact.value, rounding) << sigma;
    EXPECT_NEAR(estimate.sigma, exact.sigma, rounding) << sigma;
    EXPECT_NEAR(estimate.expanded, exact.expanded, rounding) << sigma;
  }
}

TEST(Diagnosis, EndsWhereItIsStopped) {
  std::stop_source stop;
  stop.request_stop();
  const auto diagnosis = diagnose(test::trialMeasurement("full"), {}, stop.get_token());
  ASSERT_FALSE(diagnosis);
  EXPECT_TRUE(std::holds_alternative<Stopped>(diagnosis.problem()));
}

/// Both faces, there and back. `held` are the instrument's errors; the record states `recorded` ± 1″. Both in
/// arcseconds.
Measurement withRecord(const std::map<ErrorTerm, double>& held, const std::map<std::string, double>& recorded,
                       const char* protocol = "two-face", std::uint64_t seed = 17) {
  Truth truth = drawTruth(seed);
  for (const auto& [term, size] : held) truth.effects.push_back({term, size});
  Measurement measurement = *examine(*simulate(*protocolByName(protocol), truth, seed)).measurement;
  for (const auto& [id, size] : recorded)
    for (const EffectParameter& parameter : effectById(id)->parameters)
      measurement.known.push_back({.effect = id,
                                   .parameter = std::string(parameter.name),
                                   .unit = std::string(parameter.unit),
                                   .from = "record",
                                   .value = &parameter == &effectById(id)->parameters.front() ? size : 0,
                                   .sigma = 1});
  return measurement;
}

TEST(KnownInstrument, IsNoCauseWhereItIsAsTheRecordSays) {
  const Measurement measurement = withRecord({{ErrorTerm::TrunnionTilt, 40}}, {{"trunnion_tilt", 40.5}});
  const Diagnosis diagnosis = diagnosed(measurement);
  EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::WithinNoise);
  EXPECT_THAT(diagnosis.causes, IsEmpty());
  EXPECT_GT(diagnosis.gap.rms, 1.5 * diagnosis.after.rms) << "what is known accounts for the gap";
  EXPECT_GT(diagnosis.after.pValue, 1e-3);
  EXPECT_GT(diagnosis.shrink.ofExcess, 0.9);
  EXPECT_GT(diagnosis.shrink.heldOut, 0.3);
  ASSERT_EQ(diagnosis.steps.size(), 1u);
  EXPECT_EQ(diagnosis.steps[0].effect, knownId);
  ASSERT_EQ(diagnosis.known.size(), 1u);
  const KnownCheck& check = diagnosis.known[0];
  EXPECT_EQ(check.known, 40.5);
  EXPECT_TRUE(check.isSeen);
  EXPECT_NEAR(check.value, 40, 4 * check.sigma);
  EXPECT_LT(check.staleChance, 0.02);
  Measurement unknowing = measurement;
  unknowing.known.clear();
  EXPECT_EQ(diagnosed(unknowing).verdict, DiagnosisVerdict::SingleCause);
}

TEST(KnownInstrument, IsFoundOutWhereItHasChangedSince) {
  const Diagnosis diagnosis =
      diagnosed(withRecord({{ErrorTerm::TrunnionTilt, 41}}, {{"trunnion_tilt", 3.2}, {"collimation", 0}}));
  EXPECT_EQ(diagnosis.verdict, DiagnosisVerdict::SingleCause);
  ASSERT_EQ(diagnosis.causes.size(), 1u);
  const Cause& cause = diagnosis.causes[0];
  EXPECT_EQ(cause.effect, "trunnion_tilt");
  EXPECT_TRUE(cause.isStale);
  EXPECT_GT(cause.probability, 0.99);
  EXPECT_NEAR(cause.parameters.at(0).value, 41, 4 * cause.parameters.at(0).sigma + 0.5);
  ASSERT_EQ(diagnosis.known.size(), 2u);
  for (const KnownCheck& check : diagnosis.known) {
    if (check.effect == "trunnion_tilt")
      EXPECT_GT(check.staleChance, 0.99);
    else
      EXPECT_LT(check.staleChance, 0.05);
  }
}

// With one face collimation, eccentricity, drift and form have the same trace. Known sizes of some leave the
// others.
TEST(KnownInstrument, IsTakenOutOfTheLookAlikes) {
  const std::map<ErrorTerm, double> drift{{ErrorTerm::VerticalDrift, 60}};
  const auto fromNoMark = [](Measurement measurement) {
    measurement.zeroIs = ZeroIs::Unknown;  // otherwise the zeros separate the drift from the others
    return measurement;
  };
  const Diagnosis unknowing = diagnosed(fromNoMark(withRecord(drift, {}, "paper")));
  ASSERT_EQ(unknowing.causes.size(), 1u);
  std::set<std::string> before(unknowing.causes[0].indistinguishableFrom.begin(),
                               unknowing.causes[0].indistinguishableFrom.end());
  before.insert(unknowing.causes[0].effect);
  ASSERT_TRUE(before.contains("trunnion_tilt"));
  const Diagnosis knowing = diagnosed(fromNoMark(withRecord(drift, {{"trunnion_tilt", 0}}, "paper")));
  ASSERT_EQ(knowing.causes.size(), 1u);
  EXPECT_NE(knowing.causes[0].effect, "trunnion_tilt");
  EXPECT_FALSE(knowing.causes[0].isStale);
  EXPECT_THAT(knowing.causes[0].indistinguishableFrom, Not(Contains("trunnion_tilt")));
  EXPECT_THAT(knowing.causes[0].unlessStale, Contains("trunnion_tilt"));
}

// A certificate that is certainly valid reduces U; the probability that it is out of date weakens this.
TEST(KnownInstrument, IsNoSurerThanTheRecord) {
  Measurement measurement = withRecord({}, {{"arc_ellipticity", 0}, {"arc_lobing", 0}}, "paper");
  const auto expandedWith = [&](double chance) {
    for (KnownNumber& known : measurement.known) {
      known.sigma = 0.002;
      known.staleChance = chance;
    }
    return diagnosed(measurement).measured->estimate.expanded;
  };
  const double sure = expandedWith(0), usual = expandedWith(0.02), doubtful = expandedWith(0.5);
  measurement.known.clear();
  const double none = diagnosed(measurement).measured->estimate.expanded;
  EXPECT_LE(sure, usual);
  EXPECT_LT(usual, doubtful);
  EXPECT_LT(usual, 0.9 * none);
}

TEST(KnownInstrument, ChangesNothingWhereItIsOfNoNumberOfTheCatalogue) {
  Measurement measurement = withRecord({{ErrorTerm::TrunnionTilt, 40}}, {});
  const Diagnosis before = diagnosed(measurement);
  measurement.known = {{.effect = "moonlight", .unit = "arcsec", .sigma = 1}};
  const Diagnosis after = diagnosed(measurement);
  EXPECT_EQ(after.measured->estimate.expanded, before.measured->estimate.expanded);
  EXPECT_EQ(after.causes.at(0).probability, before.causes.at(0).probability);
  EXPECT_THAT(after.known, IsEmpty());
}

}  // namespace
}  // namespace alidade
