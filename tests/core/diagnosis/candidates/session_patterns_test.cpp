#include "core/diagnosis/candidates/session_patterns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/diagnosis/session_evidence.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

// The simulator's change of the readings must equal the pattern's columns with the weights of its size.

namespace alidade {
namespace {

SessionEvidence evidenceOfPerfect(const std::string& protocol, const Truth& truth) {
  const Session session = *simulateWithoutNoise(*protocolByName(protocol), truth, 1);
  return *evidenceOf(*examine(session).measurement, std::make_shared<const SharedColumns>());
}

const EffectColumns& pattern(const std::string& follows, int order) {
  static const SharedColumns shared;
  for (const EffectColumns& columns : shared.all())
    if (columns.isPattern && columns.effect->id == follows && columns.order == order) return columns;
  ADD_FAILURE() << follows << " " << order;
  return shared.all().back();
}

/// N w = b holds for the simulated weights, to a few percent of the length of b: the readings are
/// proportional to the weights except for second-order terms.
void expectToExplain(const SessionEvidence& evidence, const EffectColumns& columns,
                     const std::vector<double>& weights) {
  double length = 0, missed = 0;
  for (std::size_t i = 0; i < columns.count; ++i) {
    const double right = evidence.explanations.front().right[columns.first + i];
    double explained = 0;
    for (std::size_t j = 0; j < columns.count; ++j)
      explained +=
          evidence.normal[evidence.columns->productAt(columns.first + i, columns.first + j)] * weights[j];
    length += right * right;
    missed += (right - explained) * (right - explained);
  }
  EXPECT_GT(length, 1);
  EXPECT_LT(std::sqrt(missed / length), 0.03) << columns.effect->id;
}

TEST(SessionPatterns, AHarmonicOfTheRadiusIsWhatTheSimulatorMakesOfIt) {
  for (const char* protocol : {"paper", "full"}) {
    Truth truth = drawTruth(3);
    truth.harmonic = {5, 0.06, -0.04};
    expectToExplain(evidenceOfPerfect(protocol, truth), pattern("radius along the guideway", 5),
                    {0.06 / 0.05, -0.04 / 0.05});
  }
}

// In both faces, whose readings differ by half a turn.
TEST(SessionPatterns, AHarmonicOfTheCircleFollowsItsReadings) {
  Truth truth = drawTruth(4);
  const double phase = 40;
  truth.foreign = {.kind = ForeignEffect::Kind::CirclePeriods, .size = 6, .first = 12, .second = phase};
  const double angle = Angle::fromDegrees(phase).radians();
  expectToExplain(evidenceOfPerfect("full", truth), pattern("horizontal readings along their circle", 12),
                  {6 * std::sin(angle) / 5, 6 * std::cos(angle) / 5});
}

TEST(SessionPatterns, BacklashIsOnTheWayBack) {
  Truth truth = drawTruth(5);
  truth.foreign = {.kind = ForeignEffect::Kind::Backlash, .size = 5, .first = 0, .second = 0};
  expectToExplain(evidenceOfPerfect("full", truth), pattern("horizontal readings on the way back", 0), {1});
}

TEST(SessionPatterns, AWarpOfHigherOrderTurnsWithTheGuideway) {
  Truth truth = drawTruth(6);
  truth.foreign = {.kind = ForeignEffect::Kind::HighWarp, .size = 0.4, .first = 4, .second = 0};
  expectToExplain(evidenceOfPerfect("full", truth), pattern("guideway out of its plane", 4), {0, 2});
}

// Products of every column with the effects' columns and with those of its own pattern have separate
// indices.
TEST(SessionPatterns, EveryProductThatIsKeptHasItsPlace) {
  std::vector<Problem> problems;
  const auto own = examineOwnEffects(
      {{.id = "dent", .formula = "radial = A*bump(s, 83°, 4°)", .parameters = {{"A", "1"}}}}, problems);
  const SharedColumns shared({own, nullptr, own});
  EXPECT_EQ(shared.effectCount(), SharedColumns().effectCount() + 1);
  std::vector<std::size_t> places;
  for (std::size_t a = 0; a < shared.count(); ++a)
    for (const EffectColumns& columns : shared.all()) {
      const bool isOwn = a >= columns.first && a < columns.first + columns.count;
      if (columns.isPattern && !isOwn) continue;
      for (std::size_t b = columns.first; b < columns.first + columns.count && b <= a; ++b)
        places.push_back(shared.productAt(a, b));
    }
  std::ranges::sort(places);
  EXPECT_EQ(std::ranges::adjacent_find(places), places.end());
  EXPECT_EQ(places.back() + 1, places.size());
}

}  // namespace
}  // namespace alidade
