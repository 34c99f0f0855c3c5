#include "core/diagnosis/observability/advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/observability/look_alikes.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/effects/cause_ids.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using Eigen::Vector2d, Eigen::VectorXd;
using testing::ElementsAre;

/// The model of readings without noise, with the visits exactly as planned.
GapModel modelBy(const Protocol& protocol, const std::vector<TrueSize>& effects) {
  Truth truth = drawTruth(11);
  truth.placeSpread = Angle();
  truth.effects = effects;
  Measurement measurement = test::measurementOf(*simulateWithoutNoise(protocol, truth, 11));
  measurement.zeroIs = ZeroIs::Unknown;  // otherwise the zeros alone separate drifts and jumps
  return *modelOf(measurement);
}

/// An inquiry into a session without an explanation so far.
Inquiry inquiryInto(GapModel model) {
  Leftover leftover(linearise(*model.measurement, *model.fit, model.options));
  return {model, model, std::move(model), std::move(leftover), {}, {}, {}, {}};
}

Inquiry paperInquiry() {
  return inquiryInto(modelBy(*protocolByName("paper"), {}));
}

Cause causeOf(const std::string& id, double size, std::vector<std::string> likes) {
  Cause cause{.effect = id,
              .probability = 1,
              .parameters = {},
              .indistinguishableFrom = std::move(likes),
              .readings = {}};
  const EffectParameter& parameter = effectById(id)->parameters[0];
  cause.parameters = {{std::string(parameter.name), size, 1, std::string(parameter.unit)}};
  return cause;
}

Cause misread(ReadingKind kind, double arcseconds, std::vector<std::string> likes) {
  Cause cause{.effect = grossErrorId,
              .probability = 1,
              .parameters = {},
              .indistinguishableFrom = std::move(likes),
              .readings = {}};
  cause.readings = {{.kind = kind, .size = arcseconds}};
  return cause;
}

Detectability undetectable(std::string_view id, VectorXd weights) {
  return {.effect = id, .weights = std::move(weights), .influence = 1, .visible = 0};
}

const Advice* adviceTo(Measure measure, const std::vector<Advice>& list) {
  const auto found = std::ranges::find(list, std::vector{measure}, &Advice::measures);
  return found == list.end() ? nullptr : &*found;
}

/// The advice that most probably leaves one answer comes first, rounded to a twentieth. Advice that separates
/// nothing clearly is absent.
void expectInOrder(const std::vector<Advice>& list) {
  ASSERT_GT(list.size(), 1u);
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_GE(list[i].bySigma, thresholds.clearlyDifferent);
    if (i == 0) continue;
    EXPECT_GE(list[i - 1].oneLeft + 0.05, list[i].oneLeft);
  }
}

PossibleCause possibleCauseOf(const std::string& id, double size) {
  const EffectParameter& parameter = effectById(id)->parameters[0];
  return {id, VectorXd::Constant(1, size / parameter.plausible)};
}

PossibleCause wrongZeroOf(std::size_t arc, double horizontal) {
  return {jumpId, Vector2d(horizontal / 60, 0), 1, arc};
}

/// The plan of the paper with one more measure, as separate sessions.
std::vector<std::pair<Measure, Protocol>> moreThanThePaper() {
  const Protocol paper = *protocolByName("paper");
  Protocol faces = paper, back = paper, slider = paper;
  faces.faces = FacePlan::BothAtEachPlace;
  back.rounds = 2;
  slider.slider = true;
  return {{Measure::BothFaces, faces}, {Measure::WayBack, back}, {Measure::SliderReadings, slider}};
}

/// Distance between the trace of `held` and the nearest trace of `other`, in a session with this protocol.
double shownApart(const Protocol& protocol, const std::pair<ErrorTerm, double>& held,
                  const std::string& other) {
  const GapModel model = *closedModelOf(modelBy(protocol, {{held.first, held.second}}));
  const Leftover leftover(linearise(*model.measurement, *model.fit, model.options));
  const Trace trace(leftover, leftover.residual());
  const std::vector<EffectComponent> effects = effectComponents(leftover, {});
  return trace.differenceFrom(*std::ranges::find(effects, other, &EffectComponent::id));
}

// The reference are sessions with the richer plan that contain one of the suspects. Their distance from any
// trace of the other suspect, whichever is the cause, is what the advice promises for every two. The advice
// is linear: 2 %.
TEST(Advice, PromisesOfEveryTwoWhatSessionsWithTheFurtherReadingsShow) {
  const std::vector<std::pair<ErrorTerm, double>> sizes{
      {ErrorTerm::VerticalDrift, 150}, {ErrorTerm::TrunnionTilt, 300}, {ErrorTerm::GravitySag, 0.4}};
  std::vector<PossibleCause> suspects;
  for (const auto& [term, size] : sizes)
    suspects.push_back(possibleCauseOf(std::string(effectOf(term)->id), size));
  const GapModel own = modelBy(*protocolByName("paper"), {});
  const Inquiry inquiry = inquiryInto(*closedModelOf(own));
  const std::vector<Advice> list = adviceFor(inquiry, suspects, {}, {});
  expectInOrder(list);
  int checked = 0;
  for (const auto& [measure, protocol] : moreThanThePaper()) {
    SCOPED_TRACE(static_cast<int>(measure));
    const Advice* advice = adviceTo(measure, list);
    if (!advice) continue;
    double least = 1e9;
    for (const auto& one : sizes)
      for (const auto& other : sizes) {
        const std::string first(effectOf(one.first)->id), second(effectOf(other.first)->id);
        const auto has = [&](const std::string& id) {
          return std::ranges::find(advice->separates, id) != advice->separates.end();
        };
        if (first != second && has(first) && has(second))
          least = std::min(least, shownApart(protocol, one, second));
      }
    EXPECT_NEAR(advice->bySigma, least, 0.02 * least);
    EXPECT_FALSE(advice->ofUndetectable);
    ++checked;
  }
  EXPECT_GE(checked, 2);
}

// A drift of 60″ has turned the zero by 29″ when 17 of 34 rows are read, in each position. A slip of 30″
// after the last zero turns it in that position only; a shift along the axis does not turn it.
TEST(Advice, SightsTheZerosAgainToTellASlipFromADriftAndAShift) {
  const Inquiry inquiry = inquiryInto(*closedModelOf(modelBy(*protocolByName("paper"), {})));
  const std::vector<Advice> list = adviceFor(
      inquiry,
      {possibleCauseOf("axial_shift", 0.3), possibleCauseOf("horizontal_drift", 60), wrongZeroOf(1, 30)}, {},
      {});
  const Advice* zero = adviceTo(Measure::ZeroSightedAgain, list);
  ASSERT_TRUE(zero);
  EXPECT_EQ(zero, &list.front());
  EXPECT_THAT(zero->separates, testing::IsSupersetOf({"axial_shift"}));
  const double sigma = 2 * std::numbers::sqrt2;
  EXPECT_NEAR(zero->bySigma, 30 / sigma,
              0.05 * 30 / sigma);  // the axial shift from each of the others; drift and slip are nearer
}

/// A jump between the zero and the first visit of a position of the paper's plan.
PossibleCause wrongZeroAt(std::size_t arc, double horizontal) {
  PossibleCause wrongZero = wrongZeroOf(arc, horizontal);
  wrongZero.moment = JumpMoment{18 * arc + 1, 18 * (arc + 1)};  // the zero precedes the 17 rows
  return wrongZero;
}

// The repeat at 0° is equal to the first position, even with a shift at 180°, unless the first zero slipped.
// A shift absorbs the readings at 180°. So two zeros and two arcs of 17 readings separate 30″ from it: √2 (2″
// ⊕ 0.37 · 2″). A slip at 180° has the same trace as a shift.
TEST(Advice, MeasuresAPositionAgainToTellASlipOfItsZeroFromAShift) {
  const Inquiry inquiry = inquiryInto(*closedModelOf(modelBy(*protocolByName("paper"), {})));
  const std::vector<Advice> ofFirst =
      adviceFor(inquiry, {possibleCauseOf("axial_shift", 0.35), wrongZeroAt(0, 30)}, {}, {});
  const Advice *again = adviceTo(Measure::At0Again, ofFirst), *other = adviceTo(Measure::At180Again, ofFirst);
  ASSERT_TRUE(again);
  EXPECT_FALSE(other) << "both 180° positions lie where a shift has them";
  EXPECT_NEAR(again->bySigma, 30 / (2 * std::numbers::sqrt2 * std::hypot(1, 0.37)), 0.1 * again->bySigma);
  EXPECT_GT(again->oneLeft, 0.99);
  const std::vector<Advice> ofSecond =
      adviceFor(inquiry, {possibleCauseOf("axial_shift", 0.35), wrongZeroAt(1, 30)}, {}, {});
  EXPECT_FALSE(adviceTo(Measure::At0Again, ofSecond));
  EXPECT_TRUE(adviceTo(Measure::At180Again, ofSecond));
  // Either zero may have slipped: only both repeated positions decide.
  const std::vector<Advice> ofEither = adviceFor(
      inquiry, {possibleCauseOf("axial_shift", 0.35), wrongZeroAt(0, 30), wrongZeroAt(1, -30)}, {}, {});
  EXPECT_FALSE(adviceTo(Measure::At0Again, ofEither));
  EXPECT_FALSE(adviceTo(Measure::At180Again, ofEither));
}

// The distances differ by twice the plane offset; a change of radius does not affect them.
TEST(Advice, MeasuresTheDistanceInBothPositions) {
  Measurement measurement = *modelBy(*protocolByName("paper"), {}).measurement;
  measurement.sigmaDistance = 0.5;
  const Inquiry inquiry = inquiryInto(*closedModelOf(*modelOf(measurement)));
  const std::vector<Advice> list =
      adviceFor(inquiry, {possibleCauseOf("plane_offset", 3), possibleCauseOf("radius_change", 1)}, {}, {});
  const Advice* distance = adviceTo(Measure::DistanceInBoth, list);
  ASSERT_TRUE(distance);
  EXPECT_THAT(distance->separates, ElementsAre("plane_offset", "radius_change"));
  EXPECT_NEAR(distance->bySigma, 6 / 0.5 / std::numbers::sqrt2, 1e-9);
}

// A way back that reveals a plausible drift, compared with a session that contains it.
TEST(Advice, TellsWhatWouldShowTheUnseenWhereNothingIsToBeToldApart) {
  const Inquiry inquiry = paperInquiry();
  const std::vector<Detectability> drifts{undetectable("vertical_drift", VectorXd::Ones(1)),
                                          undetectable("horizontal_drift", -VectorXd::Ones(1))};
  const Cause clear = causeOf("collimation", 40, {});
  for (const std::vector<Cause>& causes : {std::vector<Cause>{}, {clear}}) {
    const std::vector<Advice> list = adviceFor(inquiry, {}, causes, drifts);
    for (const auto& [measure, protocol] : moreThanThePaper()) {
      SCOPED_TRACE(static_cast<int>(measure));
      std::vector<std::string> shown;
      double least = 0;
      for (const auto& [id, size] :
           {std::pair{ErrorTerm::VerticalDrift, 15.0}, {ErrorTerm::HorizontalDrift, -15.0}}) {
        const double visible = std::sqrt(modelBy(protocol, {{id, size}}).fit->chiSquare);
        if (visible < thresholds.clearlyDifferent) continue;
        least = shown.empty() ? visible : std::min(least, visible);
        shown.emplace_back(effectOf(id)->id);
      }
      const Advice* advice = adviceTo(measure, list);
      ASSERT_EQ(advice != nullptr, !shown.empty());
      if (!advice) continue;
      EXPECT_EQ(advice->separates, shown);
      EXPECT_TRUE(advice->ofUndetectable);
      EXPECT_NEAR(advice->bySigma, least, 0.02 * least);
    }
    EXPECT_TRUE(adviceTo(Measure::WayBack, list));
  }
}

// Two sightings of the zero, each with the noise of its circle.
TEST(Advice, SightsTheZeroAgainWhereAMisreadValueMayBeAJump) {
  GapModel model = modelBy(*protocolByName("paper"), {});
  Measurement measurement = *model.measurement;
  measurement.sigmaVertical = Angle::fromArcseconds(5);
  const Inquiry inquiry = inquiryInto(*modelOf(measurement));
  const std::vector<Detectability> undetectableJump{undetectable(jumpId, Vector2d(0.6, 0.8))};
  for (const auto& [kind, sigma] : {std::pair{ReadingKind::Horizontal, 2.0}, {ReadingKind::Vertical, 5.0}}) {
    const std::vector<Advice> list = adviceFor(inquiry, {}, {misread(kind, -60, {jumpId})}, undetectableJump);
    ASSERT_EQ(list.size(), 1u);
    EXPECT_THAT(list[0].measures, ElementsAre(Measure::ZeroSightedAgain));
    EXPECT_THAT(list[0].separates, ElementsAre(grossErrorId, jumpId));
    EXPECT_NEAR(list[0].bySigma, 60 / sigma / std::numbers::sqrt2, 1e-9);
    EXPECT_FALSE(list[0].ofUndetectable);
  }
  EXPECT_TRUE(adviceFor(inquiry, {}, {misread(ReadingKind::Vertical, 60, {})}, {}).empty());
  Cause two = misread(ReadingKind::Vertical, 60, {jumpId});
  two.readings.push_back(two.readings.front());
  EXPECT_TRUE(adviceFor(inquiry, {}, {two}, {}).empty());
}

// A jump of 60″ in the direction (0.6, 0.8). The advice comes first if there is no other question, otherwise
// last.
TEST(Advice, SightsTheZeroAgainWhereAJumpGoesUnseen) {
  Measurement measurement = *modelBy(*protocolByName("paper"), {}).measurement;
  measurement.sigmaVertical = Angle::fromArcseconds(5);
  const Inquiry inquiry = inquiryInto(*modelOf(measurement));
  const std::vector<Detectability> list{undetectable("horizontal_drift", VectorXd::Ones(1)),
                                        undetectable(jumpId, Vector2d(0.6, -0.8))};
  const double expected = std::hypot(36.0 / 2, 48.0 / 5) / std::numbers::sqrt2;
  const std::vector<Advice> alone = adviceFor(inquiry, {}, {}, list),
                            amongOthers = adviceFor(
                                inquiry,
                                {possibleCauseOf("gravity_sag", 0.4), possibleCauseOf("trunnion_tilt", 200)},
                                {}, list);
  ASSERT_GT(alone.size(), 1u);
  ASSERT_GT(amongOthers.size(), 1u);
  for (const Advice& zero : {alone.front(), amongOthers.back()}) {
    EXPECT_THAT(zero.measures, ElementsAre(Measure::ZeroSightedAgain));
    EXPECT_THAT(zero.separates, ElementsAre(jumpId));
    EXPECT_NEAR(zero.bySigma, expected, 1e-9);
    EXPECT_TRUE(zero.ofUndetectable);
  }
  for (const Advice& other : amongOthers)
    EXPECT_EQ(other.ofUndetectable, other.measures.front() == Measure::ZeroSightedAgain);
}

TEST(Advice, IsNotGivenWhereNothingIsAsked) {
  EXPECT_TRUE(adviceFor(paperInquiry(), {}, {}, {}).empty());
  EXPECT_TRUE(adviceFor(paperInquiry(), {}, {causeOf("collimation", 40, {})}, {}).empty());
}

}  // namespace
}  // namespace alidade
