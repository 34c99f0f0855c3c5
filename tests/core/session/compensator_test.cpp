#include "core/session/compensator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/adjustment/result/session_findings.h"
#include "core/effects/known_sizes.h"
#include "core/observation/observe.h"
#include "core/wording/findings.h"

namespace alidade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double oneArcsec = std::numbers::pi / 180 / 3600;

/// A row at this azimuth with the compensator's readings there.
struct Row {
  double degrees = 0;
  int face = 1;
};

struct Stated {
  double aboutX = 0, aboutZ = 0;           ///< arcsec
  double indexCross = 0, indexLength = 0;  ///< arcsec
  std::optional<Corrections> corrections = Corrections();
  bool hasTilts = true;
};

ArcMeasurement arcOf(int axisDeg, const std::vector<Row>& rows, const Stated& stated) {
  ArcMeasurement arc;
  arc.axisDeg = axisDeg;
  for (const Row& row : rows) {
    Sighting sighting;
    sighting.a = Angle::fromDegrees(row.degrees);
    sighting.face = row.face;
    sighting.corrections = stated.corrections;
    if (stated.hasTilts) {
      const TiltsRead read = tiltsRead({stated.aboutX, stated.aboutZ}, sighting.a, row.face);
      sighting.tiltCross = Angle::fromArcseconds(read.cross + stated.indexCross);
      sighting.tiltLength = Angle::fromArcseconds(read.length + stated.indexLength);
    }
    arc.sightings.push_back(sighting);
  }
  return arc;
}

const std::vector<Row> oneFace = {{-9}, {-4}, {0}, {5}, {9}};
const std::vector<Row> bothFaces = {{-9}, {-9, 2}, {0}, {0, 2}, {9}, {9, 2}};

Measurement measuredWith(const std::vector<Row>& rows, const Stated& upper, const Stated& lower) {
  Measurement measurement;
  measurement.arcs = {arcOf(0, rows, upper), arcOf(180, rows, lower)};
  return measurement;
}

Measurement measuredWith(const std::vector<Row>& rows, const Stated& stated) {
  return measuredWith(rows, stated, stated);
}

std::vector<std::string> findingsOf(const Measurement& measurement) {
  std::vector<std::string> texts;
  for (const Finding& finding : inWords(modelFindings(measurement))) texts.push_back(finding.text);
  return texts;
}

// The plumb line as seen from an instrument tilted as in the forward model, with rotations written out
// independently. A liquid compensator reads the components along and across the line of sight.
TEST(Compensator, ReadsThePlumbLineInTheAlidade) {
  const AxisTilt tilt{40 * oneArcsec, -70 * oneArcsec};
  const Eigen::Matrix3d labFromInstrument = (Eigen::AngleAxisd(tilt.aboutZ, Eigen::Vector3d::UnitZ()) *
                                             Eigen::AngleAxisd(tilt.aboutX, Eigen::Vector3d::UnitX()))
                                                .toRotationMatrix();
  const Eigen::Vector3d plumb = labFromInstrument.transpose() * Eigen::Vector3d(0, -1, 0);
  for (const double degrees : {-170., -60., -9., 0., 8., 90., 135.})
    for (const int face : {1, 2}) {
      const double a = degrees * std::numbers::pi / 180, side = face == 1 ? 1 : -1;
      const Eigen::Vector3d ahead(side * std::sin(a), 0, -side * std::cos(a)),
          right = ahead.cross(Eigen::Vector3d::UnitY());
      const TiltsRead read = tiltsRead(tilt, Angle::fromDegrees(degrees), face);
      // The plumb line falls to the side to which the axis leans. Second order of 80″: 0.03″.
      EXPECT_NEAR(read.length, plumb.dot(ahead), 0.05 * oneArcsec) << degrees << ' ' << face;
      EXPECT_NEAR(read.cross, plumb.dot(right), 0.05 * oneArcsec) << degrees << ' ' << face;
    }
}

// An axis that leans towards the target raises it; one that leans to the right makes high targets read too
// far left, by the tilt times tan e.
TEST(Compensator, HasTheSignsOfTheForwardModel) {
  const double t = 50 * oneArcsec;
  const auto read = [](double aboutX, double aboutZ, SpacePoint<double> target) {
    ErrorTerms<double> errors;
    errors.set(ErrorTerm::VerticalAxisTiltX, aboutX);
    errors.set(ErrorTerm::VerticalAxisTiltZ, aboutZ);
    return circleDirection(errors, target, Pointing());
  };
  const SpacePoint<double> ahead{0, 0, -2405}, high{0, 400, -2405};
  // tx = −t: the compensator reads length = +t, and the level target appears higher by the same amount.
  EXPECT_NEAR(tiltsRead({-t, 0}, Angle(), 1).length, t, 1e-15);
  EXPECT_NEAR(read(-t, 0, ahead).e, t, 1e-9);
  // tz = −t: cross = +t, and a target at the elevation e reads δα = −t tan e.
  EXPECT_NEAR(tiltsRead({0, -t}, Angle(), 1).cross, t, 1e-15);
  EXPECT_NEAR(read(0, -t, high).a, -t * 400 / 2405, 1e-9);
}

TEST(Compensator, TellsNothingWithoutTiltsAndCorrections) {
  const Measurement measurement = measuredWith(oneFace, {.corrections = {}, .hasTilts = false});
  EXPECT_THAT(compensatorKnowledge(measurement).known, IsEmpty());
  EXPECT_THAT(findingsOf(measurement), IsEmpty());
}

TEST(Compensator, FindsTheTiltOfTheAxisFromOneFace) {
  Measurement measurement = measuredWith(oneFace, {.aboutX = 33, .aboutZ = -21});
  measurement.sigmaCompensator = Angle::fromArcseconds(0.5);
  const auto known = compensatorKnowledge(measurement).known;
  ASSERT_EQ(known.size(), 2U);
  for (const KnownNumber& number : known) ASSERT_TRUE(findParameter(measurement, number)) << number.parameter;
  EXPECT_EQ(findParameter(measurement, known[0])->term, ErrorTerm::VerticalAxisTiltX);
  EXPECT_EQ(findParameter(measurement, known[1])->term, ErrorTerm::VerticalAxisTiltZ);
  // The index is 0 ± σ and inseparable from the tilt over so few degrees: it pulls towards zero by the ratio
  // of the weights of ten rows and of σ.
  EXPECT_NEAR(known[0].value, 33, 0.01);
  EXPECT_NEAR(known[1].value, -21, 0.01);
  // The variance has three parts: the shared σ, an index with the same σ, and the mean of ten rows. The
  // rotation of 9° hardly determines the index.
  for (const KnownNumber& number : known) EXPECT_NEAR(number.sigma, 0.5 * std::sqrt(2.1), 0.03);
  EXPECT_THAT(findingsOf(measurement), IsEmpty());
}

TEST(Compensator, FreesTheTiltOfItsIndexWithBothFaces) {
  const Measurement measurement =
      measuredWith(bothFaces, {.aboutX = 33, .aboutZ = -21, .indexCross = 2, .indexLength = -3});
  const auto known = compensatorKnowledge(measurement).known;
  ASSERT_EQ(known.size(), 2U);
  EXPECT_NEAR(known[0].value, 33, 0.01);
  EXPECT_NEAR(known[1].value, -21, 0.01);
  for (const KnownNumber& number : known) EXPECT_NEAR(number.sigma, std::sqrt(1 + 9 + 1. / 12), 0.01);
}

// This also applies if a program counts tilts along the line of sight with a sign that does not change in
// face 2.
TEST(Compensator, DoesNotBelieveTiltsThatDoNotTurnOver) {
  const Measurement measurement = measuredWith(bothFaces, {.indexCross = 2, .indexLength = 30});
  EXPECT_THAT(compensatorKnowledge(measurement).known, IsEmpty());
  EXPECT_THAT(findingsOf(measurement), ElementsAre(HasSubstr("contradict each other by 30.0″")));
}

TEST(Compensator, IsLessCertainWhereTheAxisMoved) {
  const Measurement measurement = measuredWith(oneFace, {.aboutX = 10}, {.aboutX = 30});
  const auto known = compensatorKnowledge(measurement).known;
  ASSERT_EQ(known.size(), 2U);
  EXPECT_NEAR(known[0].value, 20, 0.1);
  EXPECT_NEAR(known[0].sigma, std::sqrt(2.1 + 100), 0.05);
  EXPECT_THAT(findingsOf(measurement), ElementsAre(HasSubstr("moved by 20.0″")));
}

TEST(Compensator, ThatWasOnHasTakenTheTiltOff) {
  const Measurement measurement = measuredWith(
      oneFace, {.aboutX = 33, .corrections = Corrections{.inclination = true, .standingAxis = true}});
  const auto known = compensatorKnowledge(measurement).known;
  ASSERT_EQ(known.size(), 2U);
  for (const KnownNumber& number : known) {
    EXPECT_EQ(number.effect, "vertical_axis_tilt");
    EXPECT_EQ(number.value, 0);
    EXPECT_EQ(number.sigma, 1);
    EXPECT_EQ(number.staleChance, KnownNumber().staleChance);
  }
  const Measurement halfOn = measuredWith(oneFace, {.corrections = Corrections{.inclination = true}});
  EXPECT_GT(compensatorKnowledge(halfOn).known.at(0).staleChance, known[0].staleChance);
}

TEST(Compensator, KnowsWhatTheInstrumentCalibrates) {
  const Measurement measurement = measuredWith(
      oneFace, {.corrections = Corrections{.collimation = true, .tiltingAxis = true}, .hasTilts = false});
  const auto known = compensatorKnowledge(measurement).known;
  ASSERT_EQ(known.size(), 2U);
  EXPECT_EQ(findParameter(measurement, known[0])->term, ErrorTerm::Collimation);
  EXPECT_EQ(findParameter(measurement, known[1])->term, ErrorTerm::TrunnionTilt);
  for (const KnownNumber& number : known) {
    EXPECT_EQ(number.value, 0);
    EXPECT_LT(number.sigma, findParameter(measurement, number)->plausible / 3);
  }
}

TEST(Compensator, IsCautiousWhereRowsDiffer) {
  const Corrections on{.inclination = true, .collimation = true};
  for (const std::optional<Corrections>& other : {std::optional(Corrections{.collimation = true}), {}}) {
    const Measurement measurement = measuredWith(oneFace, {.corrections = on}, {.corrections = other});
    const CompensatorKnowledge knowledge = compensatorKnowledge(measurement);
    EXPECT_EQ(knowledge.known.size(), other ? 1U : 0U);
    EXPECT_THAT(findingsOf(measurement), ElementsAre(HasSubstr(other ? "(inclination)" : "inclination")));
  }
}

TEST(Compensator, SaysWhyTiltsAreOfNoUse) {
  const Measurement measurement = measuredWith(oneFace, {.aboutX = 33, .corrections = {}});
  EXPECT_THAT(compensatorKnowledge(measurement).known, IsEmpty());
  EXPECT_THAT(findingsOf(measurement), ElementsAre(HasSubstr("are not used")));
}

}  // namespace
}  // namespace alidade
