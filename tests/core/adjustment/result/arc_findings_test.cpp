#include "core/adjustment/result/session_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/found.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using namespace arc_finding;
using test::found;
using testing::ElementsAre, testing::IsEmpty, testing::Pair, testing::SizeIs;

constexpr Circle nominalCircle{0, 0, 400};

std::vector<FitFinding> findingsOf(const Measurement& measurement, const ArcMeasurement& arc) {
  return arcFindings(measurement, arc, *fitArc(measurement, arc));
}

ArcMeasurement read(const Measurement& measurement, double span) {
  std::mt19937_64 generator(3);
  ArcMeasurement arc = test::perfectArc(measurement, nominalCircle, test::spread(17, span));
  test::addNoise(arc, measurement, generator);
  return arc;
}

TEST(ArcFindings, AreNoneWhereTheReadingsScatterAsStated) {
  const Measurement measurement = test::usualMeasurement();
  EXPECT_THAT(findingsOf(measurement, read(measurement, 160)), IsEmpty());
}

TEST(ArcFindings, SayWhichArcTheyAreOf) {
  Measurement measurement = test::usualMeasurement();
  ArcMeasurement arc = test::perfectArc(measurement, nominalCircle, test::spread(3, 160, -90), 180);
  arc.position = 4;
  const std::vector<FitFinding> findings = findingsOf(measurement, arc);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].severity, Severity::Warning);
  EXPECT_EQ(findings[0].where.path(), "positions[4].readings");
  EXPECT_EQ(std::get<ArcFinding>(findings[0].what).axisDeg, 180);
  EXPECT_TRUE(found<NothingChecks>(findings));
}

TEST(ArcFindings, TakeAnAgreementTooGoodForANote) {
  const Measurement measurement = test::usualMeasurement();
  const auto findings =
      findingsOf(measurement, test::perfectArc(measurement, nominalCircle, test::spread(17, 160)));
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].severity, Severity::Note);
  ASSERT_TRUE(found<ScattersLess>(findings));
  EXPECT_EQ(found<ScattersLess>(findings)->degreesOfFreedom, 2 * 17 - 17 - 3);
}

// The paper's arc at 0° scatters by 7.3 times the σ stated for it.
TEST(ArcFindings, TellAScatterBeyondTheNoise) {
  const Measurement paper = test::paperMeasurement();
  const auto findings = findingsOf(paper, paper.arcs[0]);
  ASSERT_TRUE(found<ScattersMore>(findings));
  EXPECT_NEAR(found<ScattersMore>(findings)->reducedChiSquare, 7.3 * 7.3, 1);
}

TEST(ArcFindings, TellAnArcTooShortForARadius) {
  const Measurement measurement = test::usualMeasurement();
  const auto findings = findingsOf(measurement, read(measurement, 5));
  ASSERT_TRUE(found<RadiusPoorlyKnown>(findings));
  EXPECT_NEAR(found<RadiusPoorlyKnown>(findings)->span.degrees(), 5, 0.5);
  EXPECT_GT(found<RadiusPoorlyKnown>(findings)->sigma, 4);  // a hundredth of the radius
}

// σ of the radius is some hundredths of a millimetre here, negligible compared with a twentieth of 400 mm.
TEST(ArcFindings, TakeATwentiethForFarFromNominal) {
  for (const auto& [nominal, far] : {std::pair(400 / 1.04, false),
                                     {400 / 0.96, false},
                                     {400 / 1.06, true},
                                     {400 / 0.94, true},
                                     {400 / 1.09, true}}) {
    Measurement measurement = test::usualMeasurement();
    measurement.nominalRadius = nominal;
    const auto findings =
        findingsOf(measurement, test::perfectArc(measurement, nominalCircle, test::spread(17, 160)));
    const auto* off = found<RadiusFarFromNominal>(findings);
    ASSERT_EQ(off != nullptr, far) << nominal;
    if (!off) continue;
    EXPECT_NEAR(off->fitted, 400, 1e-6);
    EXPECT_EQ(off->nominal, nominal);
  }
}

TEST(ArcFindings, NameTheRowsThatAreCopies) {
  const Measurement measurement = test::usualMeasurement();
  ArcMeasurement arc = read(measurement, 160);
  const auto copy = [&](std::size_t from, std::size_t to) {
    arc.sightings[to].a = arc.sightings[from].a;
    arc.sightings[to].e = arc.sightings[from].e;
  };
  copy(3, 4);
  auto findings = findingsOf(measurement, arc);
  ASSERT_TRUE(found<ReadingsRepeat>(findings));
  EXPECT_THAT(found<ReadingsRepeat>(findings)->rows, ElementsAre(Pair(3, 4)));
  arc.sightings[4].face = 2;
  findings = findingsOf(measurement, arc);
  EXPECT_FALSE(found<ReadingsRepeat>(findings)) << "read in the other face";
  copy(8, 2);
  copy(8, 11);
  copy(5, 6);
  arc.sightings[0].e = Angle::fromRadians(-0.0);
  arc.sightings[9].e = Angle::fromRadians(0.0);
  arc.sightings[9].a = arc.sightings[0].a;
  EXPECT_THAT(found<ReadingsRepeat>(findingsOf(measurement, arc))->rows,
              ElementsAre(Pair(5, 6), Pair(2, 8), Pair(0, 9), Pair(2, 11)))
      << "the first with each other one, in the order of these";
}

TEST(ArcFindings, SayThatAFitDidNotSettle) {
  const Measurement measurement = test::usualMeasurement();
  const ArcMeasurement arc = read(measurement, 160);
  ArcFit fit = *fitArc(measurement, arc);
  fit.status = FitStatus::TooManyIterations;
  fit.iterations = 60;
  const auto findings = arcFindings(measurement, arc, fit);
  ASSERT_TRUE(found<NotConverged>(findings));
  EXPECT_EQ(found<NotConverged>(findings)->iterations, 60);
}

}  // namespace
}  // namespace alidade
