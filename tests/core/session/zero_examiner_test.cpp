#include "core/session/zero_examiner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace alidade {
namespace {

using testing::ElementsAre, testing::HasSubstr, testing::IsEmpty;

const Angle sigma = Angle::fromArcseconds(2);

/// Two positions, each sighted in face 1 at 10° and 90°.
Session twoZeros() {
  Session session;
  for (const char* axis : {"0", "180"}) {
    Position& position = session.positions.emplace_back();
    position.axisDeg = axis;
    position.zero.horizontal = "10 00 00";
    position.zero.vertical = "90 00 00";
  }
  return session;
}

ExaminedZeros examined(const Session& session, PointingZeros kind = PointingZeros::Each,
                       VerticalCircle circle = VerticalCircle::Zenith) {
  return examineZeros(session, circle, kind, sigma, sigma);
}

std::vector<std::string> pathsOf(const ExaminedZeros& zeros) {
  std::vector<std::string> paths;
  for (const ExaminedZero& zero : zeros.ofPositions)
    for (const Problem& problem : zero.problems) paths.push_back(problem.where.path());
  return paths;
}

double arcsecondsFrom(Angle angle, double degrees) {
  return wrapped(angle - Angle::fromDegrees(degrees)).arcseconds();
}

TEST(ZeroExaminer, TakesOneSightingAsItIs) {
  const ExaminedZeros zeros = examined(twoZeros());
  ASSERT_TRUE(zeros.ofPositions[1].direction);
  const ZeroDirection& zero = *zeros.ofPositions[1].direction;
  EXPECT_NEAR(arcsecondsFrom(zero.horizontal, 10), 0, 1e-9);
  EXPECT_EQ(zero.sightings.count, 1);
  EXPECT_EQ(zero.sightings.factor, 1);
  EXPECT_FALSE(zero.sightings.moved);
  ASSERT_EQ(zero.each.size(), 1u);
  EXPECT_EQ(zero.each.front().a.radians(), 0);
  EXPECT_EQ(zeros.scatter, 1);
}

// Calculated by hand: face 1 reads 0″ and 4″, face 2 10″ and 14″ more, the vertical circle of face 2 360°
// minus face 1.
TEST(ZeroExaminer, TakesTheMeanOfBothFacesBeforeAndAfter) {
  Session session = twoZeros();
  for (Position& position : session.positions) {
    position.zero.after = {"10 00 04", "90 00 02"};
    position.zero.faceTwo = {"190 00 10", "269 59 54"};
    position.zero.afterInTwo = {"190 00 14", "269 59 52"};
  }
  const ExaminedZeros zeros = examined(session);
  EXPECT_THAT(pathsOf(zeros), IsEmpty());
  const ZeroDirection& zero = *zeros.ofPositions[0].direction;
  EXPECT_NEAR(arcsecondsFrom(zero.horizontal, 10), 7, 1e-9);
  EXPECT_NEAR(arcsecondsFrom(zero.vertical, 90), 4, 1e-9);
  EXPECT_EQ(zero.sightings.count, 4);
  EXPECT_DOUBLE_EQ(zero.sightings.factor, 0.5);
  EXPECT_TRUE(zero.sightings.isInBothFaces);
  ASSERT_EQ(zero.each.size(), 4u);
  EXPECT_NEAR(zero.each[0].a.arcseconds(), -7, 1e-9);
  EXPECT_NEAR(zero.each[0].e.arcseconds(), 4, 1e-9) << "up, as a zenith circle counts down";
  ASSERT_TRUE(zero.sightings.moved);
  EXPECT_NEAR(zero.sightings.moved->horizontal.arcseconds(), 4, 1e-9);
  EXPECT_NEAR(zero.sightings.moved->vertical.arcseconds(), 2, 1e-9);
  EXPECT_DOUBLE_EQ(zero.sightings.moved->factor, 1) << "the mean of two differences of two";
  // The zero is sighted twice in either face: (2² + 2²) horizontally and (1² + 1²) vertically, over 4 and 8
  // degrees of freedom.
  EXPECT_NEAR(zeros.scatter, std::sqrt((4 * 8 + 4 * 2) / 4.0 / 8), 1e-9);
}

TEST(ZeroExaminer, NeverTakesZerosToScatterLessThanStated) {
  Session session = twoZeros();
  session.positions[0].zero.after = {"10 00 00", "90 00 01"};
  EXPECT_EQ(examined(session).scatter, 1);
  session.positions[0].zero.after = {"10 00 00", "90 00 20"};
  EXPECT_NEAR(examined(session).scatter, std::sqrt(2 * 100.0 / 4 / 2), 1e-9);
  EXPECT_EQ(examineZeros(session, VerticalCircle::Zenith, PointingZeros::Each, {}, {}).scatter, 1) << "exact";
}

// Both faces have equal weight, for any number of sightings: 1/2 √(1/2 + 1).
TEST(ZeroExaminer, WeighsTheFacesAlike) {
  Session session = twoZeros();
  for (Position& position : session.positions) {
    position.zero.after = {"10 00 02", "90 00 00"};
    position.zero.faceTwo = {"190 00 09", "270 00 00"};
  }
  const ZeroDirection zero = *examined(session).ofPositions[0].direction;
  EXPECT_NEAR(arcsecondsFrom(zero.horizontal, 10), 5, 1e-9);
  EXPECT_DOUBLE_EQ(zero.sightings.factor, std::sqrt(1.5) / 2);
  EXPECT_EQ(zero.each.size(), 3u);
}

TEST(ZeroExaminer, TurnsFaceTwoOfAnElevationCircle) {
  Session session = twoZeros();
  for (Position& position : session.positions) {
    position.zero.vertical = "-0 00 04";
    position.zero.faceTwo = {"190 00 00", "180 00 00"};
  }
  const ExaminedZeros zeros = examined(session, PointingZeros::Each, VerticalCircle::Elevation);
  EXPECT_THAT(pathsOf(zeros), IsEmpty());
  EXPECT_NEAR(arcsecondsFrom(zeros.ofPositions[0].direction->vertical, 0), -2, 1e-9);
}

TEST(ZeroExaminer, LeavesOutAFaceThatNotEveryPositionHas) {
  Session session = twoZeros();
  session.positions[1].zero.faceTwo = {"190 01 00", "270 01 00"};
  const ExaminedZeros zeros = examined(session);
  for (const ExaminedZero& zero : zeros.ofPositions) {
    EXPECT_NEAR(arcsecondsFrom(zero.direction->horizontal, 10), 0, 1e-9);
    EXPECT_EQ(zero.direction->sightings.count, 1);
  }
  EXPECT_FALSE(zeros.ofPositions[0].direction->sightings.hasLeftOutFace);
  EXPECT_TRUE(zeros.ofPositions[1].direction->sightings.hasLeftOutFace);
  session.positions[0].zero.horizontal = "x";  // unusable, so it is ignored
  EXPECT_EQ(examined(session).ofPositions[1].direction->sightings.count, 2);
}

TEST(ZeroExaminer, NamesSightingsThatCannotBeUsed) {
  Session session = twoZeros();
  session.positions[0].zero.faceTwo = {"190 00 00", ""};
  session.positions[0].zero.after = {"x", "90 00 00"};
  session.positions[1].zero.faceTwo = {"10 00 00", "270 00 00"};  // the circle of face 1
  session.positions[1].zero.after = {"10 00 00", "91 00 00"};
  const ExaminedZeros zeros = examined(session);
  EXPECT_THAT(pathsOf(zeros), ElementsAre("positions[0].pointing_zero.face_2.vertical",
                                          "positions[0].pointing_zero.after.horizontal",
                                          "positions[1].pointing_zero.face_2.horizontal",
                                          "positions[1].pointing_zero.after.vertical"));
  EXPECT_THAT(zeros.ofPositions[1].problems[0].what,
              HasSubstr("“10 00 00” is 180.0° from the first sighting of the pointing zero: check the "
                        "degrees and the face"));
  for (const ExaminedZero& zero : zeros.ofPositions) EXPECT_EQ(zero.direction->sightings.count, 1);
}

TEST(ZeroExaminer, PoolsTheSightingsOfOneZero) {
  Session session = twoZeros();
  session.positions[0].zero.faceTwo = {"190 00 08", "270 00 00"};
  session.positions[1].zero.after = {"10 00 02", "90 00 00"};
  session.positions[1].zero.afterInTwo = {"190 00 10", "270 00 00"};
  const ExaminedZeros zeros = examined(session, PointingZeros::One);
  EXPECT_FALSE(zeros.isOneOfSeveral);
  for (const ExaminedZero& zero : zeros.ofPositions) {
    EXPECT_NEAR(arcsecondsFrom(zero.direction->horizontal, 10), 5, 1e-9);
    EXPECT_EQ(zero.direction->sightings.count, 4);
  }
  session.positions[0].zero.after = {"10 00 03", "90 00 00"};
  EXPECT_TRUE(examined(session, PointingZeros::One).isOneOfSeveral);
  EXPECT_FALSE(examined(session, PointingZeros::Each).isOneOfSeveral);
}

TEST(ZeroElevation, IsUpFromTheHorizonOfItsOwnCircleOnly) {
  const auto elevation = [](double vertical, VerticalCircle circle) {
    return zeroElevation(Angle::fromDegrees(vertical), circle);
  };
  // 1e-12° is a hundred times the rounding of an angle of 90°.
  EXPECT_NEAR(elevation(80, VerticalCircle::Zenith)->degrees(), 10, 1e-12);
  EXPECT_NEAR(elevation(350, VerticalCircle::Elevation)->degrees(), -10, 1e-12);
  EXPECT_TRUE(elevation(45.001, VerticalCircle::Zenith));
  EXPECT_FALSE(elevation(44.999, VerticalCircle::Zenith));
  EXPECT_TRUE(elevation(44.999, VerticalCircle::Elevation));
  EXPECT_FALSE(elevation(90, VerticalCircle::Elevation)) << "a zenith angle";
  EXPECT_FALSE(elevation(0, VerticalCircle::Zenith)) << "an elevation";
}

}  // namespace
}  // namespace alidade
