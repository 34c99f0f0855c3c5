#include "core/diagnosis/conclusion/causes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/effects/cause_ids.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Inquiry inquiryInto(const std::string& protocol, const Truth& truth, const DiagnosisOptions& options = {}) {
  return inquire(*modelOf(test::measurementOf(*simulate(*protocolByName(protocol), truth, truth.seed))),
                 options, {});
}

TrueGrossError misread(int axisDeg, int point, int face, double horizontal, double vertical) {
  return {.axisDeg = axisDeg,
          .round = 2,
          .point = point,
          .face = face,
          .horizontal = Angle::fromArcseconds(horizontal),
          .vertical = Angle::fromArcseconds(vertical)};
}

// The sizes are as simulated, for circles that count up or down and in either face. In two faces with slider
// the other readings predict one to some 2.5″; the tolerance is four times that. An error of a degree is
// excluded before the search.
TEST(Causes, BlameReadingsTogetherAndByTheirCircles) {
  for (const VerticalCircle circle : {VerticalCircle::Zenith, VerticalCircle::Elevation})
    for (const double large : {150.0, 3600.0}) {
      Truth truth = drawTruth(4);
      truth.verticalCircle = circle;
      truth.verticalZero = Angle::fromDegrees(circle == VerticalCircle::Zenith ? 90 : 0);
      truth.grossErrors = {misread(0, 6, 1, 0, 120), misread(0, 12, 2, 0, 110), misread(180, 3, 2, -130, 0),
                           misread(180, 14, 1, 0, -large)};
      const Inquiry inquiry = inquiryInto("full", truth);
      ASSERT_EQ(inquiry.excluded.size(), large > 1000 ? 1u : 0u);
      const std::vector<Cause> causes = causesOf(inquiry, conclude(inquiry));
      ASSERT_EQ(causes.size(), 1u);
      EXPECT_EQ(causes[0].effect, grossErrorId);
      EXPECT_GT(causes[0].probability, 0.999);
      EXPECT_LE(causes[0].probability, 1);
      EXPECT_THAT(causes[0].parameters, IsEmpty());
      EXPECT_THAT(causes[0].indistinguishableFrom, IsEmpty());
      ASSERT_EQ(causes[0].readings.size(), truth.grossErrors.size());
      for (const TrueGrossError& error : truth.grossErrors) {
        const auto found = std::ranges::find_if(causes[0].readings, [&](const ReadingDeviation& reading) {
          return reading.axisDeg == error.axisDeg && reading.point == error.point &&
                 reading.face == error.face && reading.round == error.round;
        });
        ASSERT_NE(found, causes[0].readings.end());
        const bool isHorizontal = error.horizontal != Angle();
        EXPECT_EQ(found->kind, isHorizontal ? ReadingKind::Horizontal : ReadingKind::Vertical);
        EXPECT_NEAR(found->size, (error.horizontal + error.vertical).arcseconds(), 10) << error.point;
      }
    }
}

// A reading that was excluded before the search does not depend on the probabilities of the search.
TEST(Causes, AreSureOfAReadingThatIsFarOff) {
  Truth truth = drawTruth(4);
  truth.grossErrors = {misread(180, 9, 2, 0, 3600)};
  const Inquiry inquiry = inquiryInto("full", truth);
  const std::vector<Cause> causes = causesOf(inquiry, conclude(inquiry));
  ASSERT_EQ(causes.size(), 1u);
  EXPECT_LT(inquiry.probabilityOf(grossErrorId), 0.5);
  EXPECT_EQ(causes[0].probability, 1);
  EXPECT_EQ(causes[0].readings.size(), 1u);
}

// The sizes are true within four σ. The probability of a cause is the sum over all explanations that contain
// it.
TEST(Causes, TellTheNumbersOfEveryPart) {
  Truth truth = drawTruth(6);
  truth.effects = {
      {ErrorTerm::Collimation, -20}, {ErrorTerm::LobingCosine, 0.15}, {ErrorTerm::LobingSine, 0.1}};
  truth.noiseFactor = 2.5;
  const Inquiry inquiry = inquiryInto("full", truth);
  const Answer answer = conclude(inquiry);
  std::map<std::string, Cause> causes;
  for (const Cause& cause : causesOf(inquiry, answer))
    EXPECT_TRUE(causes.emplace(cause.effect, cause).second);
  ASSERT_EQ(causes.size(), 3u);
  const auto expectNumber = [&](const std::string& id, std::size_t i, double truly) {
    ASSERT_TRUE(causes.contains(id));
    ASSERT_GT(causes[id].parameters.size(), i);
    const CauseParameter& number = causes[id].parameters[i];
    EXPECT_NEAR(number.value, truly, 4 * number.sigma) << id;
    EXPECT_GT(std::abs(truly), 5 * number.sigma) << id;
  };
  expectNumber("collimation", 0, -20);
  expectNumber("arc_lobing", 0, 0.15);
  expectNumber("arc_lobing", 1, 0.1);
  expectNumber(noiseId, 0, 2.5);
  // Standard uncertainty of a standard deviation from f squares: s/√(2 f). Of 340 readings 68 arc angles, two
  // circles and two slider zeros take 76. The priors of the causes' numbers compensate for these.
  const CauseParameter& noise = causes[noiseId].parameters[0];
  EXPECT_NEAR(noise.sigma, noise.value / std::sqrt(2.0 * (340 - 68 - 8)), 0.01 * noise.sigma);
  for (const auto& [id, cause] : causes) {
    double chance = 0;
    for (const Explanation& explanation : inquiry.explanations) {
      bool has = id == noiseId && explanation.noisy;
      for (const Part& part : explanation.parts) has = has || inquiry.candidates[part.component].id() == id;
      if (has) chance += explanation.chance;
    }
    EXPECT_NEAR(cause.probability, chance, 1e-12) << id;
    EXPECT_GT(cause.probability, 0.5) << id;
  }
}

// One face with 17 places hardly separates a tilt from a drift, so both are named.
TEST(Causes, NameWhatTheyCannotBeToldFrom) {
  Truth truth = drawTruth(5);
  truth.effects = {{ErrorTerm::TrunnionTilt, 90}};
  const Inquiry inquiry = inquiryInto("paper", truth);
  const Answer answer = conclude(inquiry);
  ASSERT_EQ(answer.rivals.size(), 1u);
  std::vector<std::string> rivals;
  for (const Rival& rival : answer.rivals[0]) rivals.emplace_back(inquiry.of(rival.part).id());
  ASSERT_FALSE(rivals.empty());
  const std::vector<Cause> causes = causesOf(inquiry, answer);
  ASSERT_EQ(causes.size(), 1u);
  EXPECT_EQ(causes[0].indistinguishableFrom, rivals);
  std::vector<std::string> named = rivals;
  named.push_back(causes[0].effect);
  EXPECT_THAT(named, testing::Contains("trunnion_tilt"));
}

// At the end of a pass only the last row would show a jump. If two readings are wrong, the jump is no longer
// a look-alike.
TEST(Causes, LikenOnlyASingleReadingToAJump) {
  Truth truth = drawTruth(3);
  truth.grossErrors = {misread(0, 17, 1, 60, 0)};
  truth.grossErrors[0].round = 1;
  const Inquiry inquiry = inquiryInto("paper", truth);
  Answer answer = conclude(inquiry);
  ASSERT_EQ(answer.explanation.parts.size(), 1u);
  ASSERT_TRUE(inquiry.of(answer.explanation.parts[0]).grossErrorAt());
  answer.rivals = {{{.odds = 0.1, .part = {}}}};
  EXPECT_THAT(causesOf(inquiry, answer)[0].indistinguishableFrom, ElementsAre(jumpId));
  answer.explanation.parts.push_back(answer.explanation.parts[0]);
  answer.rivals.emplace_back();
  EXPECT_THAT(causesOf(inquiry, answer)[0].indistinguishableFrom, IsEmpty());
}

// Every candidate is evaluated alone; of jumps and readings only the best. The explained part is the
// projection of the leftover on its visible columns.
TEST(CandidatesOf, AreAllEffectsByHowWellTheyExplainAlone) {
  Truth truth = drawTruth(6);
  truth.effects = {{ErrorTerm::TrunnionTilt, 25}, {ErrorTerm::LobingCosine, 0.1}};
  const Inquiry inquiry = inquiryInto("full", truth, {.without = {"gravity_sag"}});
  const std::vector<Candidate> list = candidatesOf(inquiry);
  std::set<std::string> ids;
  for (const Candidate& candidate : list)
    EXPECT_TRUE(ids.insert(candidate.effect).second) << candidate.effect;
  for (const Effect& effect : effectCatalogue())
    EXPECT_EQ(ids.contains(std::string(effect.id)), effect.isSought && effect.id != "gravity_sag")
        << effect.id;
  EXPECT_TRUE(std::ranges::is_sorted(list, std::greater{}, &Candidate::logBayesFactor));
  const SharedProducts residual(inquiry.leftover, inquiry.leftover.residual());
  std::map<std::string, std::pair<double, double>> best;  // the evidence, and how far it shows
  for (std::size_t i = 0; i < inquiry.candidates.size(); ++i) {
    const Component& component = inquiry.candidates[i];
    if (component.isShape() || component.onlyRow() || component.gram().isZero(0)) continue;
    const Part alone = fitAlone(residual, component, i);
    const double shows = component.signature(inquiry.leftover, alone.weights).norm();
    const auto [own, isFirst] = best.emplace(std::string(component.id()), std::pair(alone.logGain, shows));
    if (!isFirst && own->second.first < alone.logGain) own->second = {alone.logGain, shows};
  }
  for (const Candidate& candidate : list) {
    if (candidate.effect == noiseId) continue;
    // The search sums in a different order, and reserves 1 % of the probability for far larger jumps. This
    // jump is not one of them: its part is a millionth.
    const double keptBack = candidate.effect == jumpId ? std::log(0.99) : 0;
    EXPECT_NEAR(candidate.logBayesFactor, best.at(candidate.effect).first + keptBack, 1e-5)
        << candidate.effect;
    EXPECT_NEAR(candidate.visibleSigma, best.at(candidate.effect).second, 1e-4) << candidate.effect;
  }
  const auto noise = std::ranges::find(list, noiseId, &Candidate::effect);
  ASSERT_NE(noise, list.end());
  EXPECT_EQ(noise->visibleSigma, 0);
}

}  // namespace
}  // namespace alidade
