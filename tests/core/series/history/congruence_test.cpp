#include "core/series/history/congruence.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/series/history/device_history.h"

namespace alidade {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Δd and its σ on a day, of the device D and the instrument T, with independent lengths of σ 1.
Epoch epochAt(double day, double value, double sigma) {
  Epoch epoch{.file = std::to_string(day), .title = "s" + std::to_string(day), .date = "d", .day = day};
  epoch.deviceSerial = "D";
  epoch.instrumentSerial = "T";
  epoch.intersection = {.value = value, .sigma = sigma, .expanded = 2 * sigma, .degreesOfFreedom = infinite};
  epoch.ofFit.value = value;
  epoch.ofFit.sigma = sigma / 2;
  for (const char* id : {"o1_x", "o1_y", "radius_0", "o2_x", "o2_y", "radius_180"})
    epoch.lengths.push_back({id, 0});
  epoch.covariance = {6, std::vector<double>(36)};
  for (std::size_t i = 0; i < 6; ++i) epoch.covariance.values[7 * i] = 1;
  epoch.degreesOfFreedom = infinite;
  return epoch;
}

TEST(Congruence, OfIndependentLengthsIsASumOfSquares) {
  std::vector<Epoch> epochs = {epochAt(0, 1, 0.3), epochAt(1, 2, 0.4)};
  epochs[1].lengths[0].value = 2;  // O1 x
  epochs[1].lengths[2].value = 1;  // radius at 0°
  const Congruence congruence = congruenceOf(epochs, 0, 1);
  EXPECT_NEAR(congruence.difference, 1, 1e-12);
  EXPECT_NEAR(congruence.u, 0.5, 1e-12);
  EXPECT_NEAR(congruence.expanded, 1.959964 * 0.5, 1e-6);
  EXPECT_NEAR(congruence.chance, std::erfc(2 / std::sqrt(2.0)), 1e-9);
  EXPECT_TRUE(congruence.hasChanged);
  ASSERT_TRUE(congruence.setUp);
  EXPECT_NEAR(congruence.setUp->statistic, (4 + 1) / 2.0, 1e-12);
  // χ² of six: exp(−x/2) (1 + x/2 + x²/8).
  EXPECT_NEAR(congruence.setUp->chance, std::exp(-1.25) * (1 + 1.25 + 1.25 * 1.25 / 2), 1e-9);
  // (O1 − O2)/2 has variance 1/2 in each session.
  ASSERT_TRUE(congruence.device);
  EXPECT_NEAR(congruence.device->statistic, 1.0 / 1 + 1.0 / 2, 1e-12);
  EXPECT_THAT(congruence.device->ids,
              ElementsAre("half_difference_x", "half_difference_y", "radius_0", "radius_180"));
}

TEST(Congruence, DoesNotHangOnWhereTheTheodoliteStood) {
  std::vector<Epoch> epochs = {epochAt(0, 1, 0.3), epochAt(1, 1, 0.3)};
  for (const std::size_t y : {1, 4}) epochs[1].lengths[y].value = 100;
  const Congruence congruence = congruenceOf(epochs, 0, 1);
  EXPECT_NEAR(congruence.device->statistic, 0, 1e-12);
  EXPECT_LT(congruence.setUp->chance, 1e-12);
}

TEST(Congruence, TakesCorrelationsAlong) {
  std::vector<Epoch> epochs = {epochAt(0, 1, 0.3), epochAt(1, 1, 0.3)};
  for (Epoch& epoch : epochs) epoch.covariance.values[0 * 6 + 1] = epoch.covariance.values[1 * 6 + 0] = 0.8;
  epochs[1].lengths[0].value = 1;
  epochs[1].lengths[1].value = -1;
  // C = 2 [1 0.8; 0.8 1], d = (1, −1): dᵀC⁻¹d = 2/(2 (1 − 0.8)).
  EXPECT_NEAR(congruenceOf(epochs, 0, 1).setUp->statistic, 5, 1e-9);
}

TEST(Congruence, IsTheSameBackwards) {
  std::vector<Epoch> epochs = {epochAt(0, 1, 0.3), epochAt(1, 1.7, 0.2)};
  epochs[1].lengths[3].value = 3;
  const Congruence there = congruenceOf(epochs, 0, 1), back = congruenceOf(epochs, 1, 0);
  EXPECT_EQ(there.difference, -back.difference);
  EXPECT_EQ(there.chance, back.chance);
  EXPECT_NEAR(there.device->statistic, back.device->statistic, 1e-12);
}

TEST(Congruence, OfEstimatedScatterIsLessSure) {
  std::vector<Epoch> epochs = {epochAt(0, 1, 0.3), epochAt(1, 1, 0.3)};
  epochs[1].lengths[0].value = 4;
  const double known = congruenceOf(epochs, 0, 1).setUp->chance;
  for (Epoch& epoch : epochs) epoch.degreesOfFreedom = 8;
  const Congruence congruence = congruenceOf(epochs, 0, 1);
  EXPECT_NEAR(congruence.setUp->degreesOfFreedom, 16, 1e-9);  // for equal variances the sum
  EXPECT_GT(congruence.setUp->chance, known);
}

TEST(Congruence, LeavesOutWhatBothSessionsShare) {
  std::vector<Epoch> epochs = {epochAt(0, 1, 0.5), epochAt(1, 1, 0.5)};
  for (Epoch& epoch : epochs)
    epoch.lasting = {{"trunnion_tilt", ErrorSource::Instrument, 0.4}, {"sag", ErrorSource::Guideway, 0.2}};
  EXPECT_NEAR(sharedVariance(epochs[0], epochs[1]), 0.16 + 0.04, 1e-12);
  EXPECT_NEAR(congruenceOf(epochs, 0, 1).u, std::sqrt(2 * (0.25 - 0.2)), 1e-12);
  epochs[1].instrumentSerial = "other";
  EXPECT_NEAR(sharedVariance(epochs[0], epochs[1]), 0.04, 1e-12);
  epochs[1].deviceSerial = "";
  EXPECT_EQ(sharedVariance(epochs[0], epochs[1]), 0);
}

TEST(DeviceHistories, SortDatesAndPartDevices) {
  std::vector<Epoch> epochs = {epochAt(5, 1, 0.1), epochAt(2, 2, 0.1), epochAt(3, 3, 0.1),
                               epochAt(4, 4, 0.1)};
  epochs[2].deviceSerial = "E";
  epochs[3].date = "";
  const DeviceHistories histories = deviceHistories(epochs);
  EXPECT_THAT(histories.undated, ElementsAre(3U));
  ASSERT_THAT(histories.devices, SizeIs(2));
  ASSERT_THAT(histories.devices[0].epochs, SizeIs(2));
  EXPECT_EQ(histories.devices[0].epochs[0].intersection.value, 2);
  EXPECT_EQ(histories.devices[1].serial, "E");
  EXPECT_THAT(histories.devices[0].quantities, SizeIs(8));
  EXPECT_THAT(histories.devices[0].congruences, SizeIs(1));
}

TEST(DeviceHistories, ShareWhatLastsInTheMeanAlone) {
  std::vector<Epoch> epochs;
  for (int i = 0; i < 4; ++i) {
    epochs.push_back(epochAt(i, 1, 0.5));
    epochs.back().lasting = {{"trunnion_tilt", ErrorSource::Instrument, 0.4}};
  }
  const History history = intersectionHistory(epochs);
  EXPECT_NEAR(history.values[0].apart, 0.3, 1e-12);
  EXPECT_EQ(history.values[0].u, 0.5);
  EXPECT_NEAR(history.mean.u, std::sqrt(0.09 / 4 + 0.16), 1e-12);
  // Different parts do not cancel: shares of 0.3 and 0.5 are 0.1 off their mean.
  for (int i = 0; i < 4; ++i) epochs[static_cast<std::size_t>(i)].lasting[0].sigma = i % 2 == 0 ? 0.3 : 0.5;
  EXPECT_NEAR(intersectionHistory(epochs).values[0].apart, std::sqrt(0.25 - 0.09 + 0.01), 1e-12);
}

TEST(DeviceHistories, CompareEveryTwoOfAFewAndNeighboursOfMany) {
  EXPECT_THAT(pairsOf(1), SizeIs(0));
  EXPECT_THAT(pairsOf(20), SizeIs(190));
  EXPECT_THAT(pairsOf(21), SizeIs(21));
}

}  // namespace
}  // namespace alidade
