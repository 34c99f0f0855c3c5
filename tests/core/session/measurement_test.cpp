#include "core/session/measurement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include <chrono>

#include "core/session/session_file.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::HasSubstr;

Reading row(const char* point, const char* horizontal, const char* vertical, const char* face = "") {
  Reading reading;
  reading.point = point;
  reading.horizontal = horizontal;
  reading.vertical = vertical;
  reading.face = face;
  return reading;
}

Session soundSession() {
  Session session = blankSession();
  session.geometry.distanceMm = "2405";
  session.geometry.radiusMm = "400";
  for (Position& position : session.positions) {
    position.zero = {.horizontal = "332°32'54\"", .vertical = "89°59'57\"", .origin = {}};
    position.readings = {row("1", "341°52'24\"", "88°16'49\""), row("2", "332°27'38\"", "80°29'30\""),
                         row("3", "323°10'29\"", "88°25'21\"")};
  }
  return session;
}

/// The only problem of a session.
Problem soleProblem(const Session& session) {
  const Examined examined = examine(session);
  if (examined.problems.size() == 1) return examined.problems[0];
  std::string all;
  for (const Problem& problem : examined.problems) all += problem.text() + "\n";
  return {"not one problem but " + std::to_string(examined.problems.size()) + ":\n" + all};
}

const Sighting& firstSighting(const Examined& examined) {
  return examined.measurement->arcs.at(0).sightings.at(0);
}

TEST(Measurement, OfASoundSessionHasEveryValue) {
  Session session = soundSession();
  session.instrument.sigmaHorizontalArcsec = "1,5";
  session.instrument.sigmaVerticalArcsec = "3";
  session.geometry.sigmaDistanceMm = "1.0";
  session.acceptance.toleranceMm = "2.5";
  session.acceptance.coverage = "0.99";
  session.acceptance.referenceIntersectionMm = "-2";
  session.positions[1].readings[2].slider = "-170 00 00";
  const Examined examined = examine(session);
  ASSERT_TRUE(examined.problems.empty()) << examined.problems[0].text();
  const Measurement& m = *examined.measurement;
  EXPECT_EQ(m.distance, 2405);
  EXPECT_EQ(m.sigmaDistance, 1);
  EXPECT_EQ(m.nominalRadius, 400);
  EXPECT_DOUBLE_EQ(m.sigmaHorizontal.arcseconds(), 1.5);
  EXPECT_DOUBLE_EQ(m.sigmaVertical.arcseconds(), 3);
  EXPECT_DOUBLE_EQ(m.sigmaZeroHorizontal.arcseconds(), 2);
  EXPECT_DOUBLE_EQ(m.sigmaZeroVertical.arcseconds(), 2);
  EXPECT_DOUBLE_EQ(m.sigmaSlider.arcseconds(), 5);
  EXPECT_EQ(m.tolerance, 2.5);
  EXPECT_EQ(m.coverage, 0.99);
  EXPECT_EQ(m.referenceIntersection, -2);
  ASSERT_EQ(m.arcs.size(), 2u);
  EXPECT_EQ(m.arcs[1].axisDeg, 180);
  ASSERT_EQ(m.arcs[1].sightings.size(), 3u);
  EXPECT_EQ(m.arcs[1].sightings[2].point, 3);
  EXPECT_DOUBLE_EQ(m.arcs[1].sightings[2].slider->degrees(), -170);
  EXPECT_FALSE(m.arcs[0].sightings[0].slider);
}

TEST(Measurement, DefaultsAreThoseOfTheFormat) {
  Session session = soundSession();
  session.instrument = {};
  session.acceptance = {};
  session.model = {};
  session.geometry.verticalCircle = "";
  const Measurement m = *examine(session).measurement;
  EXPECT_DOUBLE_EQ(m.sigmaHorizontal.arcseconds(), 2);
  EXPECT_DOUBLE_EQ(m.sigmaVertical.arcseconds(), 2);
  EXPECT_DOUBLE_EQ(m.sigmaSlider.arcseconds(), 5);
  EXPECT_EQ(m.sigmaDistance, 0);
  EXPECT_EQ(m.coverage, 0.95);
  EXPECT_FALSE(m.tolerance);
  EXPECT_FALSE(m.referenceIntersection);
  EXPECT_EQ(m.verticalCircle, VerticalCircle::Zenith);
  EXPECT_EQ(m.relation, VerticalAngleRelation::Exact);
}

TEST(Measurement, SigmaOfTheZeroIsByDefaultThatOfEachCircle) {
  Session session = soundSession();
  session.instrument.sigmaHorizontalArcsec = "1";
  session.instrument.sigmaVerticalArcsec = "3";
  session.instrument.sigmaZeroArcsec = "";
  EXPECT_DOUBLE_EQ(examine(session).measurement->sigmaZeroHorizontal.arcseconds(), 1);
  EXPECT_DOUBLE_EQ(examine(session).measurement->sigmaZeroVertical.arcseconds(), 3);
  EXPECT_TRUE(examine(session).measurement->zerosAreReadings);
  session.instrument.sigmaZeroArcsec = "0";
  EXPECT_FALSE(examine(session).measurement->zerosAreReadings);
  EXPECT_EQ(examine(session).measurement->sigmaZeroHorizontal.radians(), 0);
  EXPECT_EQ(examine(session).measurement->sigmaZeroVertical.radians(), 0);
}

struct Reduction {
  const char* circle;
  const char *zeroHorizontal, *zeroVertical;
  const char *horizontal, *vertical, *face;
  double a, e;  ///< degrees
};

class Reduced : public testing::TestWithParam<Reduction> {};

TEST_P(Reduced, IsRightAndUpPositive) {
  const Reduction& given = GetParam();
  Session session = soundSession();
  session.geometry.verticalCircle = given.circle;
  session.positions.resize(1);
  session.positions[0].zero.horizontal = given.zeroHorizontal;
  session.positions[0].zero.vertical = given.zeroVertical;
  session.positions[0].readings = {row("1", given.horizontal, given.vertical, given.face)};
  const Examined examined = examine(session);
  ASSERT_TRUE(examined.problems.empty()) << examined.problems[0].text();
  EXPECT_NEAR(firstSighting(examined).a.degrees(), given.a, 1e-12);
  EXPECT_NEAR(firstSighting(examined).e.degrees(), given.e, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Zenith, Reduced,
                         testing::Values(Reduction{"zenith", "10°", "90°", "15°", "88°", "1", 5, 2},
                                         Reduction{"zenith", "10°", "90°", "5°", "93°", "1", -5, -3},
                                         Reduction{"zenith", "2°", "90°", "357°", "88°", "1", -5, 2},
                                         Reduction{"zenith", "357°", "89°30'", "2°", "90°", "1", 5, -0.5},
                                         Reduction{"zenith", "10°", "90°", "195°", "272°", "2", 5, 2},
                                         Reduction{"zenith", "355°", "90°", "180°", "267°", "2", 5, -3},
                                         Reduction{"zenith", "10°", "91°", "195°", "271°", "2", 5, 2}));

INSTANTIATE_TEST_SUITE_P(Elevation, Reduced,
                         testing::Values(Reduction{"elevation", "10°", "0°", "15°", "2°", "1", 5, 2},
                                         Reduction{"elevation", "10°", "0°", "15°", "358°", "1", 5, -2},
                                         Reduction{"elevation", "10°", "359°59'", "15°", "-2°", "1", 5,
                                                   -2 + 1. / 60},
                                         Reduction{"elevation", "10°", "0°", "195°", "178°", "2", 5, 2},
                                         Reduction{"elevation", "10°", "1°", "195°", "182°", "2", 5, -3}));

TEST(Measurement, BothFacesOfOnePlaceReduceToTheSameDirection) {
  const auto session = loadSession(ALIDADE_REFERENCE_DIR "/trials/sessions/505499.alidade");
  ASSERT_TRUE(session) << session.problem().text();
  const Examined examined = examine(*session);
  ASSERT_TRUE(examined.problems.empty()) << examined.problems[0].text();
  int pairs = 0;
  for (const ArcMeasurement& arc : examined.measurement->arcs) {
    for (const Sighting& one : arc.sightings) {
      for (const Sighting& two : arc.sightings) {
        if (one.face != 1 || two.face != 2 || one.point != two.point || one.round != two.round) continue;
        ++pairs;
        const double sixSigma =
            6 * std::sqrt(2.0) * 2;  // arcseconds; a clean session with σ = 2″ in both faces
        EXPECT_NEAR(one.a.arcseconds(), two.a.arcseconds(), sixSigma);
        EXPECT_NEAR(one.e.arcseconds(), two.e.arcseconds(), sixSigma);
      }
    }
  }
  EXPECT_EQ(pairs, 68);
}

TEST(Measurement, LeavesOutRowsWithAnUnusableEntryAndNamesThem) {
  Session session = soundSession();
  session.positions[1].readings[1].vertical = "88°71'49\"";
  const Examined examined = examine(session);
  ASSERT_EQ(examined.problems.size(), 1u);
  EXPECT_EQ(examined.problems[0].text(),
            "positions[1].readings[1].vertical: “88°71'49\"” has 71 minutes: minutes go from 0 to 59");
  ASSERT_EQ(examined.measurement->arcs[1].sightings.size(), 2u);
  EXPECT_EQ(examined.measurement->arcs[1].sightings[1].row, 2u);
}

TEST(Measurement, NamesReadingsOutsideTheirCircle) {
  Session session = soundSession();
  session.positions[0].readings[0].horizontal = "361°";
  EXPECT_EQ(soleProblem(session).what, "“361°” lies outside 0°…360°: check the degrees");
  session.positions[0].readings[0].horizontal = "360";
  EXPECT_THAT(soleProblem(session).what, HasSubstr("lies outside"));
  session = soundSession();
  session.positions[0].readings[0].vertical = "-1°";
  EXPECT_THAT(soleProblem(session).what, HasSubstr("lies outside 0°…360°"));
  session = soundSession();
  session.positions[0].readings[0].slider = "-361°";
  EXPECT_THAT(soleProblem(session).what, HasSubstr("lies outside −360°…360°"));
}

TEST(Measurement, NamesReadingsFarFromThePointingZero) {
  Session session = soundSession();
  session.positions[0].readings[0].horizontal = "161°52'24\"";
  EXPECT_THAT(
      soleProblem(session).text(),
      HasSubstr("positions[0].readings[0].horizontal: “161°52'24\"” lies 171° from the pointing zero"));
  session = soundSession();
  session.positions[0].readings[1].face = "2";
  const Examined examined = examine(session);
  ASSERT_EQ(examined.problems.size(), 2u) << "face 1 readings marked as face 2 are off in both circles";
  EXPECT_THAT(examined.problems[0].what, HasSubstr("check the degrees and the face"));
}

TEST(Measurement, LeavesOutAPositionWithoutUsableZero) {
  Session session = soundSession();
  session.positions[0].zero.vertical = "";
  const Examined examined = examine(session);
  ASSERT_EQ(examined.problems.size(), 1u);
  EXPECT_THAT(examined.problems[0].text(),
              HasSubstr("positions[0].pointing_zero.vertical: is empty: type an angle"));
  ASSERT_EQ(examined.measurement->arcs.size(), 1u);
  EXPECT_EQ(examined.measurement->arcs[0].position, 1u);
}

TEST(Measurement, HasWhatIsKnownOfTheInstrumentThenOfTheDevice) {
  Session session = soundSession();
  session.device.known = {{.effect = "plane_warp", .parameter = "sine", .sigma = "0.1", .unit = "mm"}};
  session.instrument.known = {
      {.effect = "collimation", .value = "-3.2", .sigma = "0.5", .unit = "arcsec", .from = "check"}};
  const std::vector<KnownNumber> known = examine(session).measurement->known;
  ASSERT_EQ(known.size(), 2u);
  EXPECT_EQ(known[0].where.path(), "instrument.known[0]");
  EXPECT_EQ(known[0].effect + known[0].unit + known[0].from, "collimationarcseccheck");
  EXPECT_EQ(known[0].value, -3.2);
  EXPECT_EQ(known[0].sigma, 0.5);
  EXPECT_EQ(known[1].parameter, "sine");
  EXPECT_EQ(known[1].value, 0) << "left empty";
}

TEST(Measurement, NamesWhatCannotBeKnownSo) {
  for (const auto& [value, sigma, where, what] :
       {std::tuple("1", "", "instrument.known[0].sigma", "is empty: type the standard uncertainty"),
        std::tuple("1", "0", "instrument.known[0].sigma", "“0” is out of range"),
        std::tuple("1", "-2", "instrument.known[0].sigma", "“-2” is out of range"),
        std::tuple("x", "1", "instrument.known[0].value", "“x”"),
        std::tuple("2e6", "1", "instrument.known[0].value", "“2e6” is out of range")}) {
    Session session = soundSession();
    session.instrument.known = {{.effect = "collimation", .value = value, .sigma = sigma, .unit = "arcsec"}};
    const Problem problem = soleProblem(session);
    EXPECT_EQ(problem.where.path(), where);
    EXPECT_THAT(problem.what, HasSubstr(what));
    EXPECT_TRUE(examine(session).measurement->known.empty());
  }
}

TEST(Measurement, NamesWhatIsNoPositionOfTheAxis) {
  Session session = soundSession();
  session.positions[1].axisDeg = "90";
  EXPECT_THAT(soleProblem(session).what, HasSubstr("“90” is no position of the axis: type 0 or 180"));
}

// If an axis repeats the order of the file is that of the measurement, else 0° was taken first.
TEST(Measurement, TakesAnAxisThatComesAgainInTheOrderOfTheFile) {
  for (const std::vector<std::string>& axes :
       {std::vector<std::string>{"0", "180", "0"}, {"180", "0", "180"}, {"0", "0"}, {"180", "0", "0", "0"}}) {
    Session session = soundSession();
    const Position one = session.positions[0];
    session.positions.clear();
    for (const std::string& axis : axes) {
      session.positions.push_back(one);
      session.positions.back().axisDeg = axis;
    }
    const Examined examined = examine(session);
    EXPECT_TRUE(examined.problems.empty());
    const Measurement& measurement = *examined.measurement;
    ASSERT_EQ(measurement.arcs.size(), axes.size());
    std::map<int, int> repeats;
    std::size_t rows = 0;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const ArcMeasurement& arc = measurement.arcs[i];
      EXPECT_EQ(arc.position, i);
      EXPECT_EQ(std::to_string(arc.axisDeg), axes[i]);
      EXPECT_EQ(arc.repeat, ++repeats[arc.axisDeg]);
      EXPECT_EQ(arc.sightings.front().sequence, rows);
      rows += one.readings.size();
    }
    EXPECT_TRUE(hasRepeats(measurement));
    EXPECT_EQ(hasBothAxes(measurement), axes.size() > 2);
  }
  const Measurement once = *examine(soundSession()).measurement;
  EXPECT_FALSE(hasRepeats(once));
  EXPECT_EQ(firstAtTheirAxes(once), (std::vector<std::size_t>{0, 1}));
}

// An unusable position still counts: the next one at its axis is the second repeat.
TEST(Measurement, CountsPositionsAtAnAxisWithThoseThatCannotBeUsed) {
  Session session = soundSession();
  session.positions.push_back(session.positions[0]);
  session.positions[0].zero.vertical = "";
  const Measurement measurement = *examine(session).measurement;
  ASSERT_EQ(measurement.arcs.size(), 2u);
  EXPECT_EQ(measurement.arcs[1].repeat, 2);
  EXPECT_EQ(firstAtTheirAxes(measurement), (std::vector<std::size_t>{0, 1}));
  EXPECT_FALSE(hasRepeats(measurement));
}

TEST(Measurement, KeepsTheFirstOfTwoRowsWithOnePointRoundAndFace) {
  Session session = soundSession();
  session.positions[0].readings[2].point = "1";
  EXPECT_EQ(soleProblem(session).text(),
            "positions[0].readings[2].point: point 1, round 1, face 1 is already in row 1: give it another "
            "point or "
            "round, or exclude one");
  EXPECT_EQ(examine(session).measurement->arcs[0].sightings.size(), 2u);
  session.positions[0].readings[2].round = "2";
  EXPECT_TRUE(examine(session).problems.empty());
  session.positions[0].readings[2].round = "";
  session.positions[0].readings[0].excluded = true;
  EXPECT_TRUE(examine(session).problems.empty());
}

TEST(Measurement, TakesTheRowNumberWhereThePointIsLeftOut) {
  Session session = soundSession();
  for (Reading& reading : session.positions[0].readings) reading.point = "";
  const Examined examined = examine(session);
  ASSERT_TRUE(examined.problems.empty()) << examined.problems[0].text();
  EXPECT_EQ(examined.measurement->arcs[0].sightings[0].point, 1);
  EXPECT_EQ(examined.measurement->arcs[0].sightings[2].point, 3);
}

TEST(Measurement, DoesNotExamineExcludedRows) {
  Session session = soundSession();
  session.positions[0].readings[1].vertical = "lost";
  session.positions[0].readings[1].excluded = true;
  const Examined examined = examine(session);
  EXPECT_TRUE(examined.problems.empty());
  EXPECT_EQ(examined.measurement->arcs[0].sightings.size(), 2u);
}

TEST(Measurement, NamesIncompleteRows) {
  Session session = soundSession();
  session.positions[0].readings.push_back({});
  EXPECT_THAT(soleProblem(session).text(),
              HasSubstr("positions[0].readings[3].horizontal: is empty, as is the whole row"));
  session.positions[0].readings[3].horizontal = "332°";
  EXPECT_THAT(soleProblem(session).text(), HasSubstr("positions[0].readings[3].vertical: is empty"));
}

TEST(Measurement, IsAbsentWithoutDistanceRadiusSigmaOrModel) {
  const auto broken = [](auto change) {
    Session session = soundSession();
    change(session);
    const Examined examined = examine(session);
    return !examined.measurement && examined.problems.size() == 1;
  };
  EXPECT_TRUE(broken([](Session& s) { s.geometry.distanceMm = ""; }));
  EXPECT_TRUE(broken([](Session& s) { s.geometry.distanceMm = "0"; }));
  EXPECT_TRUE(broken([](Session& s) { s.geometry.radiusMm = "-400"; }));
  EXPECT_TRUE(broken([](Session& s) { s.geometry.sigmaDistanceMm = "-1"; }));
  EXPECT_TRUE(broken([](Session& s) { s.instrument.sigmaHorizontalArcsec = "0"; }));
  EXPECT_TRUE(broken([](Session& s) { s.instrument.sigmaVerticalArcsec = "3600"; }));
  EXPECT_TRUE(broken([](Session& s) { s.instrument.sigmaZeroArcsec = "-1"; }));
  EXPECT_TRUE(broken([](Session& s) { s.instrument.sigmaSliderArcsec = "x"; }));
  EXPECT_TRUE(broken([](Session& s) { s.geometry.verticalCircle = "nadir"; }));
  EXPECT_TRUE(broken([](Session& s) { s.geometry.pointingZeros = "none"; }));
  EXPECT_TRUE(broken([](Session& s) { s.model.verticalAngle = "round"; }));
}

TEST(Measurement, StandsWithoutVerdictWhereToleranceOrCoverageIsUnusable) {
  Session session = soundSession();
  session.acceptance.toleranceMm = "0";
  EXPECT_THAT(soleProblem(session).text(), HasSubstr("acceptance.tolerance_mm: “0” is out of range"));
  EXPECT_FALSE(examine(session).measurement->tolerance);
  session.acceptance.toleranceMm = "1";
  session.acceptance.coverage = "95";
  EXPECT_THAT(soleProblem(session).what, HasSubstr("it must be between 0 and 1, such as 0.95"));
  EXPECT_FALSE(examine(session).measurement->tolerance);
}

TEST(Measurement, HasOneZeroWhereItIsStatedAndTheSameEverywhere) {
  Session session = test::paperSession();
  EXPECT_FALSE(examine(session).measurement->hasOneZero());
  session.geometry.pointingZeros = "one";
  session.positions[0].readings[0].horizontal = "x";
  const Examined differing = examine(session);
  ASSERT_EQ(differing.problems.size(), 2u);
  EXPECT_THAT(
      differing.problems[0].text(),
      HasSubstr("geometry.pointing_zeros: is stated as “one”, but the positions have different zeros"));
  EXPECT_FALSE(differing.measurement->hasOneZero());
  session.positions[1].zero = session.positions[0].zero;
  EXPECT_TRUE(examine(session).measurement->hasOneZero());
}

// Closed form: L (1 + α (T − 20 K)), and σ(L) combined with L α σ(T).
TEST(Measurement, TakesLengthsToTheTemperatureOfTheSession) {
  Session session = soundSession();
  const Measurement stated = *examine(session).measurement;
  session.environment.temperatureC = "27.5";
  EXPECT_EQ(examine(session).measurement->distance, stated.distance) << "no coefficient is stated";
  session.environment.sigmaTemperatureC = "2";
  session.geometry.distanceExpansionPpmPerK = "-1.5";
  session.geometry.radiusExpansionPpmPerK = "11.5";
  const Measurement warm = *examine(session).measurement;
  EXPECT_NEAR(warm.distanceExpansion, stated.distance * -1.5e-6 * 7.5, 1e-12);
  EXPECT_NEAR(warm.distance, stated.distance + warm.distanceExpansion, 1e-9);
  EXPECT_NEAR(warm.sigmaDistance, std::hypot(stated.sigmaDistance, stated.distance * 1.5e-6 * 2), 1e-12);
  EXPECT_NEAR(warm.nominalRadius, stated.nominalRadius * (1 + 11.5e-6 * 7.5), 1e-9);
  EXPECT_NEAR(warm.sigmaRadius, std::hypot(stated.sigmaRadius, stated.nominalRadius * 11.5e-6 * 2), 1e-12);
  session.environment.temperatureC.clear();
  const Examined without = examine(session);
  ASSERT_EQ(without.problems.size(), 2u);
  EXPECT_THAT(without.problems[0].text(), HasSubstr("geometry.distance_expansion_ppm_per_k: has no effect "
                                                    "without a temperature: type the temperature"));
  EXPECT_EQ(without.measurement->distance, stated.distance);
  session.geometry.distanceExpansionPpmPerK = "5000";
  EXPECT_FALSE(examine(session).measurement);
}

TEST(Measurement, HasATolerancesMeasurand) {
  Session session = test::paperSession();
  EXPECT_EQ(examine(session).measurement->measurand, Measurand::Intersection);
  session.acceptance.measurand = "distance";
  EXPECT_EQ(examine(session).measurement->measurand, Measurand::Distance);
  session.acceptance.measurand = "height";
  EXPECT_THAT(
      soleProblem(session).text(),
      HasSubstr(
          "acceptance.measurand: “height” is no quantity for a tolerance: choose intersection or distance"));
  EXPECT_FALSE(examine(session).measurement->tolerance);
}

TEST(Measurement, ReportsProblemsInTheOrderOfTheFile) {
  Session session = soundSession();
  session.measuredOn = "yesterday";
  session.instrument.sigmaHorizontalArcsec = "x";
  session.environment.temperatureC = "warm";
  session.geometry.radiusMm = "x";
  session.acceptance.coverage = "2";
  session.model.verticalAngle = "x";
  session.model.radius = "x";
  session.positions[0].zero.horizontal = "x";
  session.positions[0].readings[0].face = "3";
  session.positions[1].axisDeg = "";
  std::vector<std::string> places;
  for (const Problem& problem : examine(session).problems) places.push_back(problem.where.path());
  EXPECT_THAT(places, testing::ElementsAre("measured_on", "instrument.sigma_horizontal_arcsec",
                                           "environment.temperature_c", "geometry.radius_mm",
                                           "acceptance.coverage", "model.vertical_angle", "model.radius",
                                           "positions[0].pointing_zero.horizontal",
                                           "positions[0].readings[0].face", "positions[1].axis_deg"));
}

TEST(Measurement, NoticesEffectsThatTheFitsDoNotEstimate) {
  std::string text = writeSession(soundSession());
  EXPECT_TRUE(examine(*readSession(text)).measurement->effects.empty());
  const std::string relation = "\"vertical_angle\": \"exact\"";
  text.replace(text.find(relation), relation.size(), relation + ", \"effects\": [\"trunnion_tilt\"]");
  EXPECT_EQ(examine(*readSession(text)).measurement->effects, std::vector<std::string>{"trunnion_tilt"});
}

TEST(Measurement, EverySampleAndReferenceSessionIsSound) {
  for (const char* file :
       {ALIDADE_SAMPLES_DIR "/paper-table-1.alidade", ALIDADE_SAMPLES_DIR "/clean-session.alidade",
        ALIDADE_REFERENCE_DIR "/trials/sessions/566796.alidade",
        ALIDADE_REFERENCE_DIR "/trials/sessions/827247.alidade"}) {
    const auto session = loadSession(file);
    ASSERT_TRUE(session) << session.problem().text();
    const Examined examined = examine(*session);
    EXPECT_TRUE(examined.problems.empty()) << examined.problems[0].text();
    EXPECT_EQ(examined.measurement->arcs.size(), 2u);
  }
}

// Long positions are examined in parallel.
TEST(Measurement, OfLongPositionsIsInTheOrderOfTheFileToo) {
  constexpr std::size_t rows = 4000, wrong = 1000;
  Session session = soundSession();
  for (Position& position : session.positions) {
    position.readings.clear();
    for (std::size_t i = 0; i < rows; ++i)
      position.readings.push_back(
          row(std::to_string(i + 1).c_str(), "332°27'38\"", i % wrong == wrong - 1 ? "x" : "80°29'30\""));
  }
  const Examined examined = examine(session);
  std::vector<std::string> places, expected;
  for (const Problem& problem : examined.problems) places.push_back(problem.where.path());
  for (const char* position : {"positions[0]", "positions[1]"})
    for (std::size_t i = wrong - 1; i < rows; i += wrong)
      expected.push_back(position + (".readings[" + std::to_string(i) + "].vertical"));
  EXPECT_EQ(places, expected);
  ASSERT_EQ(examined.measurement->arcs.size(), 2u);
  std::size_t sequence = 0;
  for (const ArcMeasurement& arc : examined.measurement->arcs) {
    EXPECT_EQ(arc.axisDeg, arc.position == 0 ? 0 : 180);
    ASSERT_EQ(arc.sightings.size(), rows - rows / wrong);
    EXPECT_EQ(arc.sightings.front().sequence, sequence);
    EXPECT_EQ(arc.sightings.back().row, rows - 2);
    sequence += rows;
  }
}

TEST(Measurement, OfManyRowsTakesTimeInProportion) {
  Session session = soundSession();
  for (int i = 4; i < 100000; ++i) {
    session.positions[0].readings.push_back(row(std::to_string(i).c_str(), "332°27'38\"", "80°29'30\""));
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(examine(session).problems.empty());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(elapsed.count(), 30) << "a fraction of a second in a release build; minutes if it were quadratic";
}

}  // namespace
}  // namespace alidade
