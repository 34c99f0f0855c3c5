#include "core/series/shared_causes/diagnose_series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/session/own_effects.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/wording/series_words.h"

// Series simulated from known truths, each of sessions too short to show the shared cause alone.

namespace alidade {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Drawn {
  std::string protocol = "two-face";
  std::size_t count = 8;
  std::uint64_t seed = 1;
  std::function<void(Truth&, std::size_t)> put = [](Truth&, std::size_t) {};
  std::function<std::string(std::size_t)> instrument = [](std::size_t) { return "T-1"; };
  std::function<std::string(std::size_t)> guideway = [](std::size_t s) { return "G-" + std::to_string(s); };
  std::function<std::vector<OwnEffect>(std::size_t)> own = [](std::size_t) {
    return std::vector<OwnEffect>();
  };
};

std::vector<SeriesSession> drawn(const Drawn& how) {
  std::vector<SeriesSession> sessions;
  for (std::size_t s = 0; s < how.count; ++s) {
    const std::uint64_t seed = 1000 * how.seed + s;
    Truth truth = drawTruth(seed);
    std::vector<Problem> problems;
    truth.own = examineOwnEffects(how.own(s), problems);
    EXPECT_THAT(problems, IsEmpty());
    how.put(truth, s);
    Session session = *simulate(*protocolByName(how.protocol), truth, seed);
    session.ownEffects = how.own(s);
    session.instrument.serial = how.instrument(s);
    session.device.serial = how.guideway(s);
    session.measuredOn = "2026-01-" + std::string(s < 9 ? "0" : "") + std::to_string(s + 1);
    sessions.push_back(seriesSession("no " + std::to_string(s), session, *examine(session).measurement));
  }
  return sessions;
}

SeriesDiagnosis answerTo(const std::vector<SeriesSession>& sessions,
                         const SeriesOptions& options = {.withSessions = false}) {
  auto outcome = diagnoseSeries(sessions, options);
  EXPECT_TRUE(outcome);
  return (*std::move(outcome)).diagnosis;
}

/// Visible by some 2.5 σ in a session of two faces.
void tiltTrunnion(Truth& truth, std::size_t) {
  truth.effects = {{ErrorTerm::TrunnionTilt, 4}};
}

// One error of an instrument reads with opposite signs on circles of both kinds.
TEST(DiagnoseSeries, SharesAnErrorOfTheVerticalCircleBetweenBothKinds) {
  const auto put = [](Truth& truth, std::size_t s) {
    const bool isElevation = s % 2 == 1;
    truth.effects = {{ErrorTerm::VerticalIndex, isElevation ? -12.0 : 12.0}};
    if (!isElevation) return;
    truth.verticalCircle = VerticalCircle::Elevation;
    truth.verticalZero = Angle();
  };
  const SeriesDiagnosis series = answerTo(drawn({.count = 6, .put = put}));
  ASSERT_EQ(series.causes.size(), 1u);
  EXPECT_EQ(series.causes[0].cause.effect, "vertical_index");
  const CauseParameter& index = series.causes[0].cause.parameters.front();
  EXPECT_NEAR(index.value, 12, 3.3 * index.sigma);
  EXPECT_TRUE(series.hasBothCircles);
}

TEST(DiagnoseSeries, NamesWhatNoSessionShowsAlone) {
  const SeriesDiagnosis series = answerTo(drawn({.put = tiltTrunnion}));
  ASSERT_EQ(series.causes.size(), 1u);
  const SharedCause& cause = series.causes.front();
  EXPECT_EQ(cause.cause.effect, "trunnion_tilt");
  EXPECT_EQ(cause.owner, CauseOwner::Instrument);
  EXPECT_EQ(cause.serial, "T-1");
  EXPECT_EQ(cause.sessions.size(), 8u);
  EXPECT_FALSE(cause.isDrifting);
  EXPECT_THAT(cause.cause.indistinguishableFrom, IsEmpty());
  EXPECT_EQ(series.verdict, DiagnosisVerdict::SingleCause);
  // Within 3.3 u of the truth: exceeded by a thousandth of all draws.
  const CauseParameter& tilt = cause.cause.parameters.front();
  EXPECT_NEAR(tilt.value, 4, 3.3 * tilt.sigma);
  EXPECT_LT(tilt.sigma, 1);
  EXPECT_LT(series.after.reducedChiSquare, series.gap.reducedChiSquare);
  EXPECT_GT(series.shrink.heldOut, 0);
}

// Independent sessions of one plan: information adds, so four times the sessions have half the u. The prior
// of 9″ and more has a weight below a hundredth of it.
TEST(DiagnoseSeries, MoreSessionsKnowTheSizeBetter) {
  const SeriesDiagnosis few = answerTo(drawn({.count = 4, .put = [](Truth& truth, std::size_t) {
                                                truth.effects = {{ErrorTerm::TrunnionTilt, 20}};
                                              }}));
  const SeriesDiagnosis many = answerTo(drawn({.count = 16, .put = [](Truth& truth, std::size_t) {
                                                 truth.effects = {{ErrorTerm::TrunnionTilt, 20}};
                                               }}));
  ASSERT_FALSE(few.causes.empty() || many.causes.empty());
  EXPECT_NEAR(many.causes.front().cause.parameters.front().sigma,
              few.causes.front().cause.parameters.front().sigma / 2,
              0.05 * few.causes.front().cause.parameters.front().sigma);
}

TEST(DiagnoseSeries, IsSilentWhereNothingIsShared) {
  const SeriesDiagnosis series = answerTo(drawn({.seed = 5}));
  EXPECT_THAT(series.causes, IsEmpty());
  EXPECT_EQ(series.verdict, DiagnosisVerdict::WithinNoise);
}

// In one face without slider a trunnion tilt leaves the same trace as a warp; only the serials separate them.
TEST(DiagnoseSeries, SerialsTellLookAlikesApart) {
  const auto tilt = [](Truth& truth, std::size_t) { truth.effects = {{ErrorTerm::TrunnionTilt, 40}}; };
  const SeriesDiagnosis apart = answerTo(drawn({.protocol = "paper", .put = tilt}));
  ASSERT_FALSE(apart.causes.empty());
  EXPECT_EQ(apart.causes.front().cause.effect, "trunnion_tilt");
  EXPECT_EQ(apart.causes.front().owner, CauseOwner::Instrument);
  EXPECT_THAT(apart.causes.front().cause.indistinguishableFrom, Not(Contains("plane_warp")));

  const SeriesDiagnosis alike = answerTo(
      drawn({.protocol = "paper", .put = tilt, .guideway = [](std::size_t) { return std::string("G-1"); }}));
  ASSERT_FALSE(alike.causes.empty());
  const Cause& first = alike.causes.front().cause;
  EXPECT_TRUE(first.effect == "plane_warp" ||
              std::ranges::count(first.indistinguishableFrom, "plane_warp") == 1);
  EXPECT_TRUE(first.effect == "trunnion_tilt" ||
              std::ranges::count(first.indistinguishableFrom, "trunnion_tilt") == 1);
  EXPECT_EQ(alike.verdict, DiagnosisVerdict::Ambiguous);
  // The same two together again would never separate them.
  ASSERT_FALSE(alike.advice.empty());
  EXPECT_NE(alike.advice.front().what, SeriesAdvice::What::Again);
}

TEST(DiagnoseSeries, AnotherInstrumentHasItsOwnSize) {
  const SeriesDiagnosis series =
      answerTo(drawn({.count = 12,
                      .put =
                          [](Truth& truth, std::size_t s) {
                            if (s % 2 == 0) truth.effects = {{ErrorTerm::TrunnionTilt, 6}};
                          },
                      .instrument = [](std::size_t s) { return s % 2 == 0 ? "T-1" : "T-2"; },
                      .guideway = [](std::size_t s) { return "G-" + std::to_string(s % 3); }}));
  ASSERT_FALSE(series.causes.empty());
  EXPECT_EQ(series.causes.front().cause.effect, "trunnion_tilt");
  EXPECT_EQ(series.causes.front().serial, "T-1");
  EXPECT_THAT(series.causes.front().sessions, testing::ElementsAre(0, 2, 4, 6, 8, 10));
}

TEST(DiagnoseSeries, OneMisreadValueSpoilsNothing) {
  const SeriesDiagnosis series = answerTo(drawn({.put = [](Truth& truth, std::size_t s) {
    tiltTrunnion(truth, s);
    if (s == 3)
      truth.grossErrors = {{.axisDeg = 0,
                            .round = 1,
                            .point = 8,
                            .face = 1,
                            .horizontal = Angle::fromArcseconds(200),
                            .vertical = {}}};
  }}));
  ASSERT_FALSE(series.causes.empty());
  EXPECT_EQ(series.causes.front().cause.effect, "trunnion_tilt");
  const CauseParameter& tilt = series.causes.front().cause.parameters.front();
  EXPECT_NEAR(tilt.value, 4, 3.3 * tilt.sigma);
  ASSERT_EQ(series.sessions[3].own.size(), 1u);
  EXPECT_EQ(series.sessions[3].own.front().effect, "gross_error");
  EXPECT_THAT(series.sessions[2].own, IsEmpty());
}

/// A cause of the sessions' common guideway, faint in each (some 3 σ).
Drawn ofOneGuideway(double amplitude) {
  return {.put =
              [amplitude](Truth& truth, std::size_t) {
                truth.harmonic = {5, amplitude, 0};
              },
          .instrument = [](std::size_t s) { return "T-" + std::to_string(s % 4); },
          .guideway = [](std::size_t) { return std::string("G-1"); }};
}

std::string sameGuideway(std::size_t) {
  return "G-1";
}

std::vector<OwnEffect> ownEffect(const std::string& formula, const std::string& plausible) {
  return {{.id = "own", .formula = formula, .parameters = {{.name = "A", .plausible = plausible}}}};
}

// Each session shows the own effect by some 3 σ, like the catalogued effect in the tests above.
TEST(DiagnoseSeries, NamesAnOwnEffectThatSessionsAloneHardlyShow) {
  struct Case {
    const char *formula, *plausible;
    ErrorTerm term;
    double size;
    CauseOwner owner;
    const char* serial;
  };
  for (const Case& its :
       {Case{"radial = A*bump(s, 83°, 8°)", "0.2", ErrorTerm::OwnGuideway, 0.02, CauseOwner::Guideway, "G-1"},
        Case{"horizontal = A*cos(5*alpha)", "10", ErrorTerm::OwnInstrument, 0.4, CauseOwner::Instrument,
             "T-1"}}) {
    const SeriesDiagnosis series =
        answerTo(drawn({.count = 10,
                        .put =
                            [&](Truth& truth, std::size_t) {
                              truth.effects = {{its.term, its.size}};
                            },
                        .guideway = sameGuideway,
                        .own = [&](std::size_t) { return ownEffect(its.formula, its.plausible); }}));
    ASSERT_EQ(series.causes.size(), 1u) << its.formula;
    const SharedCause& cause = series.causes.front();
    EXPECT_EQ(cause.cause.effect, "own:own");
    EXPECT_EQ(cause.owner, its.owner);
    EXPECT_EQ(cause.serial, its.serial);
    EXPECT_EQ(cause.sessions.size(), 10u);
    EXPECT_LT(cause.visibleInOne, 4) << its.formula << " " << cause.visibleInOne;
    const CauseParameter& size = cause.cause.parameters.front();
    EXPECT_NEAR(size.value, its.size, 3 * size.sigma) << its.formula;
    EXPECT_LT(size.sigma, its.size / 4) << its.formula;
    EXPECT_EQ(series.verdict, DiagnosisVerdict::SingleCause);
    const auto alone = std::ranges::count_if(
        series.sessions, [](const SeriesMember& member) { return !member.causesAlone.empty(); });
    EXPECT_LE(alone, 2) << "of ten: what 3 σ show by chance";
  }
}

// Effects of two devices are kept from forms by the same name; each acts in the sessions of its own device.
TEST(DiagnoseSeries, OwnEffectsOfOneNameAreNotMixedUp) {
  const auto isFirst = [](std::size_t s) { return s % 2 == 0; };
  const SeriesDiagnosis series = answerTo(
      drawn({.count = 12,
             .put =
                 [&](Truth& truth, std::size_t s) {
                   truth.effects = {{ErrorTerm::OwnGuideway, isFirst(s) ? 0.05 : -0.05}};
                 },
             .guideway = [&](std::size_t s) { return isFirst(s) ? "G-1" : "G-2"; },
             .own =
                 [&](std::size_t s) {
                   return ownEffect(
                       isFirst(s) ? "radial = A*bump(s, 50°, 8°)" : "radial = A*bump(s, 110°, 8°)", "0.2");
                 }}));
  ASSERT_EQ(series.causes.size(), 2u);
  for (const SharedCause& cause : series.causes) {
    EXPECT_EQ(cause.cause.effect, "own:own");
    const bool isOfFirst = cause.serial == "G-1";
    EXPECT_EQ(cause.sessions, isOfFirst ? (std::vector<std::size_t>{0, 2, 4, 6, 8, 10})
                                        : (std::vector<std::size_t>{1, 3, 5, 7, 9, 11}));
    const CauseParameter& size = cause.cause.parameters.front();
    EXPECT_NEAR(size.value, isOfFirst ? 0.05 : -0.05, 3 * size.sigma);
  }
}

// `without` may name an own effect that only some sessions have. An effect that no session has is refused.
TEST(DiagnoseSeries, LeavesOutAnOwnEffectThatOnlySomeHave) {
  const std::vector<SeriesSession> sessions =
      drawn({.count = 3, .guideway = sameGuideway, .own = [](std::size_t s) {
               return s == 1 ? ownEffect("radial = A*cos(7*s)", "0.2") : std::vector<OwnEffect>();
             }});
  EXPECT_EQ(answerTo(sessions, {.without = {"own:own"}, .withSessions = false}).sessions.size(), 3u);
  EXPECT_FALSE(diagnoseSeries(sessions, {.without = {"own:other"}}));
}

/// Sessions of the guideway G-1 with a dent at the place `atDeg` of each session.
SeriesDiagnosis dented(std::size_t count, const std::function<double(std::size_t)>& atDeg,
                       double depth = 0.15) {
  return answerTo(
      drawn({.protocol = "full",
             .count = count,
             .put =
                 [&](Truth& truth, std::size_t s) {
                   truth.foreign = {
                       .kind = ForeignEffect::Kind::LocalDent, .size = depth, .first = atDeg(s), .second = 8};
                 },
             .guideway = sameGuideway}),
      {});
}

TEST(DiagnoseSeries, OffersAFormOfThreeSessionsAsAnEffect) {
  const SeriesDiagnosis series = dented(4, [](std::size_t s) { return s == 2 ? 120.0 : 70.0; });
  ASSERT_EQ(series.offered.size(), 1u);
  const OfferedEffect& offered = series.offered.front();
  EXPECT_THAT(offered.sessions, testing::ElementsAre(0, 1, 3));
  EXPECT_EQ(offered.effect.device, "G-1");
  EXPECT_EQ(offered.effect.instrument, "");
  EXPECT_EQ(offered.effect.from, "found in 3 sessions, first in “no 0”");
  EXPECT_FALSE(ownEffectProblem(offered.effect));
  const auto number = [](const FoundForm& form, const std::string& name) {
    return *std::ranges::find(form.parameters, name, &FormNumber::name);
  };
  // Within 3.3 u: exceeded by a thousandth of all draws. u is that of a mean of three.
  const FormNumber at = number(offered.form, "at_deg"), depth = number(offered.form, "amplitude_mm");
  EXPECT_NEAR(at.value, 70, 3.3 * at.sigma);
  EXPECT_NEAR(std::abs(depth.value), 0.15, 3.3 * depth.sigma);
  EXPECT_LT(at.sigma, number(series.sessions[0].diagnosis.forms.front(), "at_deg").sigma);
  EXPECT_NEAR(offered.form.form.numbers[0], Angle::fromDegrees(at.value).radians(), 1e-12);
  EXPECT_EQ(offered.form.formula, offered.effect.formula);
}

TEST(DiagnoseSeries, OffersNothingThatNoThreeSessionsShow) {
  const SeriesDiagnosis two = dented(2, [](std::size_t) { return 70.0; }),
                        different =
                            dented(3, [](std::size_t s) { return 50.0 + 30.0 * static_cast<double>(s); }),
                        clean = dented(
                            3, [](std::size_t) { return 70.0; }, 0);
  EXPECT_FALSE(two.sessions[0].diagnosis.forms.empty());
  EXPECT_FALSE(different.sessions[0].diagnosis.forms.empty());
  EXPECT_THAT(two.offered, IsEmpty());
  EXPECT_THAT(different.offered, IsEmpty());
  EXPECT_THAT(clean.offered, IsEmpty());
}

// A fifth harmonic of the radius is uncatalogued. All sessions of the guideway share it, whether or not a
// single session shows it.
TEST(DiagnoseSeries, WhatNoCatalogueHoldsIsToldAsThat) {
  for (const double amplitude : {0.01, 0.14}) {
    const SeriesDiagnosis series = answerTo(drawn(ofOneGuideway(amplitude)));
    EXPECT_EQ(series.verdict, DiagnosisVerdict::NotInCatalogue) << amplitude;
    ASSERT_TRUE(series.pattern) << amplitude;
    EXPECT_EQ(series.pattern->follows, "radius along the guideway");
    EXPECT_EQ(series.pattern->order, 5);
    EXPECT_EQ(series.pattern->owner, CauseOwner::Guideway);
    EXPECT_EQ(series.pattern->serial, "G-1");
    EXPECT_EQ(series.pattern->sessions.size(), 8u);
    EXPECT_GT(series.pattern->probability, 0.9);
    EXPECT_THAT(series.causes, IsEmpty()) << amplitude;
    EXPECT_GT(series.shrink.heldOut, 0);
  }
}

// Without a shared cause, or with a catalogued one, no pattern is reported.
TEST(DiagnoseSeries, NoPatternStandsInForNothingOrForAnEffect) {
  for (const bool isTilted : {false, true}) {
    const SeriesDiagnosis series =
        isTilted ? answerTo(drawn({.put = tiltTrunnion})) : answerTo(drawn({.seed = 5}));
    EXPECT_FALSE(series.pattern) << isTilted;
    EXPECT_LT(series.unknownChance, 0.2) << isTilted;
  }
}

// One session that scatters four times as much does not affect the seven others.
TEST(DiagnoseSeries, NoiseOfOneSessionIsNotThatOfAll) {
  const SeriesDiagnosis series = answerTo(drawn({.put = [](Truth& truth, std::size_t s) {
    tiltTrunnion(truth, s);
    if (s == 3) truth.noiseFactor = 4;
  }}));
  ASSERT_FALSE(series.causes.empty());
  EXPECT_EQ(series.causes.front().cause.effect, "trunnion_tilt");
  for (const SharedCause& cause : series.causes) {
    if (cause.cause.effect != "underestimated_noise") continue;
    EXPECT_THAT(cause.sessions, testing::ElementsAre(3));
  }
  ASSERT_EQ(series.sessions[3].own.size(), 1u);
  EXPECT_EQ(series.sessions[3].own.front().effect, "underestimated_noise");
}

// If all sessions scatter like this, the instrument is the owner.
TEST(DiagnoseSeries, NoiseOfAllIsThatOfTheInstrument) {
  const SeriesDiagnosis series =
      answerTo(drawn({.put = [](Truth& truth, std::size_t) { truth.noiseFactor = 1.6; }}));
  ASSERT_EQ(series.causes.size(), 1u);
  EXPECT_EQ(series.causes.front().cause.effect, "underestimated_noise");
  EXPECT_EQ(series.causes.front().sessions.size(), 8u);
  const CauseParameter& ratio = series.causes.front().cause.parameters.front();
  EXPECT_NEAR(ratio.value, 1.6, 3.3 * ratio.sigma);
}

TEST(DiagnoseSeries, ASessionThatDoesNotShareItIsSetApart) {
  const SeriesDiagnosis series = answerTo(drawn({.put = [](Truth& truth, std::size_t s) {
    truth.effects = {{ErrorTerm::TrunnionTilt, s == 5 ? -25.0 : 12.0}};
  }}));
  ASSERT_FALSE(series.causes.empty());
  const SharedCause& cause = series.causes.front();
  EXPECT_EQ(cause.cause.effect, "trunnion_tilt");
  const CauseParameter& tilt = cause.cause.parameters.front();
  EXPECT_NEAR(tilt.value, 12, 3.3 * tilt.sigma);
  // The session is reported either as not sharing the cause, or as having an additional cause of its own.
  EXPECT_TRUE(std::ranges::count(cause.apart, 5u) == 1 || !series.sessions[5].own.empty());
}

TEST(DiagnoseSeries, TellsASizeThatDrifts) {
  const SeriesDiagnosis series =
      answerTo(drawn({.count = 10, .put = [](Truth& truth, std::size_t s) {
                        truth.effects = {{ErrorTerm::TrunnionTilt, 2.0 * static_cast<double>(s)}};
                      }}));
  ASSERT_FALSE(series.causes.empty());
  const SharedCause& cause = series.causes.front();
  EXPECT_EQ(cause.cause.effect, "trunnion_tilt");
  EXPECT_TRUE(cause.isDrifting);
  ASSERT_EQ(cause.sizes.size(), 10u);
  EXPECT_NEAR(cause.sizes.back().parameters.front().value, 18,
              4 * cause.sizes.back().parameters.front().sigma);
}

TEST(DiagnoseSeries, WithoutSerialsNothingIsShared) {
  const auto none = [](std::size_t) { return std::string(); };
  const SeriesDiagnosis series = answerTo(drawn({.put = tiltTrunnion, .instrument = none, .guideway = none}));
  EXPECT_EQ(series.withoutInstrument, 8u);
  EXPECT_EQ(series.withoutGuideway, 8u);
  for (const SharedCause& cause : series.causes)
    EXPECT_TRUE(cause.sessions.size() == 1 || !cause.sizes.empty());
}

TEST(DiagnoseSeries, GivesNoCommonSizeOfSizesOfEachSession) {
  const auto tilt = [](Truth& truth, std::size_t) { truth.effects = {{ErrorTerm::TrunnionTilt, 8}}; };
  const SeriesDiagnosis series =
      answerTo(drawn({.put = tilt, .instrument = [](std::size_t) { return std::string(); }}));
  ASSERT_FALSE(series.causes.empty());
  const SharedCause& cause = series.causes.front();
  EXPECT_EQ(cause.sizes.size(), 8u);
  EXPECT_THAT(cause.cause.parameters, IsEmpty());
  EXPECT_EQ(ownerText(cause), "the instrument of each session");
  EXPECT_THAT(sentenceOf(series), HasSubstr("trunnion tilt, with its own size in each session"));
  for (const SeriesAdvice& advice : series.advice) EXPECT_THAT(sentenceOf(advice), Not(HasSubstr("?")));
}

TEST(DiagnoseSeries, AdvisesMoreSessionsEvenWithoutSerials) {
  EXPECT_EQ(sentenceOf(SeriesAdvice{.separates = {"trunnion_tilt"}, .bySigma = 6, .sessions = 4}),
            "Measure 4 more sessions: trunnion tilt would then be detectable at 6.0 σ.");
}

TEST(DiagnoseSeries, NeitherOrderNorThreadsMatter) {
  std::vector<SeriesSession> sessions = drawn({.put = tiltTrunnion});
  const SeriesDiagnosis one = answerTo(sessions, {.threads = 1});
  const SeriesDiagnosis three = answerTo(sessions, {.threads = 3});
  std::ranges::reverse(sessions);
  const SeriesDiagnosis reversed = answerTo(sessions, {.threads = 2});
  for (const SeriesDiagnosis* other : {&three, &reversed}) {
    ASSERT_EQ(one.causes.size(), other->causes.size());
    for (std::size_t c = 0; c < one.causes.size(); ++c) {
      EXPECT_EQ(one.causes[c].cause.effect, other->causes[c].cause.effect);
      EXPECT_EQ(one.causes[c].cause.parameters.front().value,
                other->causes[c].cause.parameters.front().value);
    }
    for (std::size_t s = 0; s < one.sessions.size(); ++s) {
      EXPECT_EQ(one.sessions[s].name, other->sessions[s].name);
      EXPECT_EQ(one.sessions[s].diagnosis.verdict, other->sessions[s].diagnosis.verdict);
    }
  }
}

// A session's knowledge of its shared effect is exactly as certain as the result of the other sessions.
TEST(DiagnoseSeries, ASessionKnowsWhatTheOthersSay) {
  const SeriesDiagnosis series = answerTo(drawn({.put = tiltTrunnion}));
  for (const SeriesMember& member : series.sessions) {
    ASSERT_EQ(member.shared.size(), 1u);
    EXPECT_EQ(member.shared.front().effect, "trunnion_tilt");
    EXPECT_GT(member.shared.front().sigma, series.causes.front().cause.parameters.front().sigma);
  }
}

TEST(DiagnoseSeries, OneSessionThatCannotBeUsedStopsNothing) {
  std::vector<SeriesSession> sessions = drawn({.put = tiltTrunnion});
  for (ArcMeasurement& arc : sessions[2].measurement.arcs) arc.sightings.clear();
  const auto outcome = diagnoseSeries(sessions, {.withSessions = false});
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome->unusable.size(), 1u);
  EXPECT_EQ(outcome->unusable.front().first, 2u);
  EXPECT_EQ(outcome->diagnosis.sessions.size(), 7u);
}

TEST(DiagnoseSeries, RefusesNoSessionsAndUnknownEffects) {
  EXPECT_FALSE(diagnoseSeries({}));
  EXPECT_FALSE(diagnoseSeries(drawn({.count = 2}), {.without = {"phlogiston"}}));
}

TEST(DiagnoseSeries, StopsWhenItIsAskedTo) {
  std::stop_source source;
  source.request_stop();
  const auto outcome = diagnoseSeries(drawn({.count = 3}), {}, source.get_token());
  ASSERT_FALSE(outcome);
  EXPECT_TRUE(std::holds_alternative<Stopped>(outcome.problem()));
}

}  // namespace
}  // namespace alidade
