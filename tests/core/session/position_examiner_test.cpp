#include "core/session/position_examiner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/number_text.h"

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// An angle as typed: 0°…360°, to some 1e-12 degrees.
std::string typed(double degrees) {
  return fixedText(std::fmod(degrees + 720, 360), 12) + "°";
}

/// A row read by a theodolite turned by `a` and `e` from a zero at 10° on the horizon.
Reading rowAt(double a, double e, int face = 1, VerticalCircle circle = VerticalCircle::Zenith) {
  const bool zenith = circle == VerticalCircle::Zenith;
  Reading row;
  row.face = std::to_string(face);
  row.horizontal = typed(10 + a + (face == 2 ? 180 : 0));
  row.vertical = typed(face == 1 ? (zenith ? 90 - e : e) : (zenith ? 270 + e : 180 - e));
  return row;
}

Position positionWith(std::vector<Reading> rows, const char* zeroVertical = "90°") {
  Position position;
  position.axisDeg = "0";
  position.zero.horizontal = "10°";
  position.zero.vertical = zeroVertical;
  position.readings = std::move(rows);
  return position;
}

ExaminedZero zeroOf(const Position& position, const std::optional<VerticalCircle>& circle) {
  Session session;
  session.positions = {position};
  return examineZeros(session, circle, PointingZeros::Each, {}, {}).ofPositions.front();
}

ExaminedPosition examined(const Position& position,
                          const std::optional<VerticalCircle>& circle = VerticalCircle::Zenith) {
  return examinePosition(position, 0, 0, zeroOf(position, circle), circle);
}

std::vector<std::string> pathsOf(const ExaminedPosition& position) {
  std::vector<std::string> paths;
  for (const Problem& problem : position.problems) paths.push_back(problem.where.path());
  return paths;
}

// The readings are any circle reading, and a zero up to a degree off the horizon. Twelve decimals of a degree
// leave 1e-12.
TEST(PositionExaminer, ReducesEitherFaceOfEitherCircle) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> anywhere(0, 360), wide(-79.9, 79.9);
  for (const auto circle : {VerticalCircle::Zenith, VerticalCircle::Elevation})
    for (int i = 0; i < 50; ++i) {
      const double a = wide(random), e = wide(random), turn = anywhere(random), index = wide(random) / 80;
      Position position;
      const bool zenith = circle == VerticalCircle::Zenith;
      position.zero.horizontal = typed(10 + turn);
      position.zero.vertical = typed(zenith ? 90 + index : index);
      for (const int face : {1, 2})
        position.readings.push_back(rowAt(a + turn, e + (zenith ? -index : index), face, circle));
      const ExaminedPosition result = examined(position, circle);
      ASSERT_THAT(pathsOf(result), IsEmpty());
      ASSERT_EQ(result.sightings.size(), 2u);
      for (const Sighting& sighting : result.sightings) {
        EXPECT_NEAR(sighting.a.degrees(), a, 1e-11);
        EXPECT_NEAR(sighting.e.degrees(), e, 1e-11);
        EXPECT_EQ(sighting.face, static_cast<int>(sighting.row) + 1);
      }
    }
}

TEST(PositionExaminer, CountsRowsAsTheSessionDoes) {
  Position position = positionWith({rowAt(1, 1), rowAt(2, 2), rowAt(3, 3), rowAt(4, 4)});
  position.readings[1].excluded = true;
  position.readings[1].face = "nonsense";
  position.readings[2].slider = "5 x";
  position.readings[3].slider = "-5 30 00";
  const auto zenith = VerticalCircle::Zenith;
  const ExaminedPosition result = examinePosition(position, 3, 40, zeroOf(position, zenith), zenith);
  EXPECT_THAT(pathsOf(result), ElementsAre("positions[3].readings[2].slider"));
  ASSERT_EQ(result.sightings.size(), 2u);
  const Sighting &first = result.sightings[0], &last = result.sightings[1];
  EXPECT_EQ(std::tuple(first.row, first.sequence, first.point, first.round), std::tuple(0u, 40u, 1, 1));
  EXPECT_EQ(std::tuple(last.row, last.sequence, last.point, last.round), std::tuple(3u, 43u, 4, 1));
  EXPECT_FALSE(first.slider);
  ASSERT_TRUE(last.slider);
  EXPECT_DOUBLE_EQ(last.slider->degrees(), -5.5);
}

// Some hundred rows with random numbers; excluded ones do not conflict.
TEST(PositionExaminer, RefusesTheSamePointRoundAndFaceOnly) {
  std::mt19937 random(5);
  const std::vector<std::string> points{"", "0", "1", "2", "40", "999999999"}, rounds{"", "1", "2", "60"};
  Position position = positionWith({});
  std::map<std::tuple<std::string, std::string, int>, std::size_t> firstRows;
  std::vector<std::size_t> kept;
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < 200; ++i) {
    const int face = random() % 2 == 0 ? 1 : 2;
    Reading row = rowAt(1, 2, face);
    row.point = points[random() % points.size()];
    row.round = rounds[random() % rounds.size()];
    if (face == 1 && random() % 2 == 0) row.face.clear();
    row.excluded = random() % 4 == 0;
    position.readings.push_back(row);
    if (row.excluded) continue;
    const std::string point = row.point.empty() ? std::to_string(i + 1) : row.point,
                      round = row.round.empty() ? "1" : row.round;
    const auto [first, isNew] = firstRows.try_emplace({point, round, face}, i + 1);
    if (isNew)
      kept.push_back(i);
    else
      sentences.push_back("positions[0].readings[" + std::to_string(i) + "].point: point " + point +
                          ", round " + round + ", face " + std::to_string(face) + " is already in row " +
                          std::to_string(first->second) + ": give it another point or round, or exclude one");
  }
  const ExaminedPosition result = examined(position);
  std::vector<std::size_t> rows;
  for (const Sighting& sighting : result.sightings) rows.push_back(sighting.row);
  EXPECT_EQ(rows, kept);
  std::vector<std::string> texts;
  for (const Problem& problem : result.problems) texts.push_back(problem.text());
  EXPECT_EQ(texts, sentences);
}

// 80° to either side, up and down.
TEST(PositionExaminer, RefusesWhatLiesFarFromTheZero) {
  for (const auto circle : {VerticalCircle::Zenith, VerticalCircle::Elevation})
    for (const int face : {1, 2})
      for (const double sign : {-1.0, 1.0}) {
        const Position position = positionWith(
            {rowAt(sign * 79.99, sign * 79.99, face, circle), rowAt(sign * 80.01, sign * 79.99, face, circle),
             rowAt(sign * 79.99, sign * 80.01, face, circle)},
            circle == VerticalCircle::Zenith ? "90°" : "0°");
        const ExaminedPosition result = examined(position, circle);
        EXPECT_THAT(pathsOf(result),
                    ElementsAre("positions[0].readings[1].horizontal", "positions[0].readings[2].vertical"));
        EXPECT_EQ(result.sightings.size(), 1u);
      }
}

// Every entry that can be judged is judged, independently of the others. If the kind of circle is unknown,
// elevations below the horizon pass.
TEST(PositionExaminer, JudgesRowsThatNothingCanBeReducedFrom) {
  Position position = positionWith({rowAt(1, 1), rowAt(2, 2), {}, rowAt(4, 4), rowAt(170, 0)}, "lost");
  position.readings[1].horizontal = "400°";
  position.readings[1].slider = "x";
  position.readings[3].vertical = "-5°";
  const std::vector<std::string> always{
      "positions[0].pointing_zero.vertical", "positions[0].readings[1].horizontal",
      "positions[0].readings[1].slider", "positions[0].readings[2].horizontal"};
  std::vector<std::string> withZenith = always;
  withZenith.emplace_back("positions[0].readings[3].vertical");
  const ExaminedPosition result = examined(position, VerticalCircle::Zenith);
  EXPECT_EQ(pathsOf(result), withZenith);
  EXPECT_THAT(result.sightings, IsEmpty());
  EXPECT_EQ(pathsOf(examined(position, VerticalCircle::Elevation)), always);
  EXPECT_EQ(pathsOf(examined(position, std::nullopt)), always);
}

}  // namespace
}  // namespace alidade
