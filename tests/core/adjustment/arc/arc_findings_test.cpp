#include "core/adjustment/arc/arc_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using testing::AllOf, testing::ContainsRegex, testing::HasSubstr, testing::Not;

std::string findingsOf(const Measurement& measurement, const ArcMeasurement& arc) {
  std::string all;
  for (const Finding& finding : arcFindings(measurement, arc, *fitArc(measurement, arc)))
    all += finding.text + "\n";
  return all;
}

TEST(ArcFindings, SaysWhatAFitThatStandsCannotCarry) {
  const Measurement measurement = test::usualMeasurement();
  const Circle circle{0, 0, 400};
  std::mt19937_64 generator(3);
  ArcMeasurement usual = test::perfectArc(measurement, circle, test::spread(17, 160));
  test::addNoise(usual, measurement, generator);
  EXPECT_EQ(findingsOf(measurement, usual), "");

  EXPECT_THAT(findingsOf(measurement, test::perfectArc(measurement, circle, test::spread(3, 160))),
              HasSubstr("nothing checks them"));
  EXPECT_THAT(findingsOf(measurement, test::perfectArc(measurement, circle, test::spread(17, 160))),
              HasSubstr("far better than their stated noise"));

  ArcMeasurement shortArc = test::perfectArc(measurement, circle, test::spread(17, 5));
  test::addNoise(shortArc, measurement, generator);
  EXPECT_THAT(findingsOf(measurement, shortArc),
              ContainsRegex("an arc of [45]\\.[0-9]° fixes the radius to"));

  ArcMeasurement copied = usual;
  copied.sightings[4].a = copied.sightings[3].a;
  copied.sightings[4].e = copied.sightings[3].e;
  EXPECT_THAT(findingsOf(measurement, copied), HasSubstr("in rows 4 and 5"));

  Measurement otherRadius = measurement;
  otherRadius.nominalRadius = 300;
  EXPECT_THAT(findingsOf(otherRadius, usual), HasSubstr("far from the nominal 300.0 mm"));

  const Measurement paper = test::paperMeasurement();
  EXPECT_THAT(findingsOf(paper, paper.arcs[0]), HasSubstr("scatter 7.3 times their stated noise"));
}

// σ of the radius is some hundredths of a millimetre here: beside a twentieth of 400 mm it does not count.
TEST(ArcFindings, TakesATwentiethForFarFromNominal) {
  const Circle circle{0, 0, 400};
  for (const auto& [nominal, far] : {std::pair(400 / 1.04, false),
                                     {400 / 0.96, false},
                                     {400 / 1.06, true},
                                     {400 / 0.94, true},
                                     {400 / 1.09, true}}) {
    Measurement measurement = test::usualMeasurement();
    measurement.nominalRadius = nominal;
    const std::string findings =
        findingsOf(measurement, test::perfectArc(measurement, circle, test::spread(17, 160)));
    EXPECT_EQ(findings.find("is far from the nominal") != std::string::npos, far) << nominal;
  }
}

// The part of the circle that was not sighted is the widest gap, wherever φ = ±180° lies.
// A short arc has a small sagitta; a wide one, or one of no number, has something else.
TEST(ArcFindings, BlamesTheShortArcOnlyWhereItIsShort) {
  ArcFit fit;
  fit.circle.radius = 400;
  fit.cofactor[2][2] = 100 * 100;
  EXPECT_FALSE(radiusUndetermined(fit)) << "a quarter of the radius";
  fit.cofactor[2][2] = 200 * 200;
  const auto spanning = [&](double radians) {
    fit.residuals.assign(3, {});
    for (std::size_t i = 0; i < 3; ++i) fit.residuals[i].arcAngle = radians / 2 * static_cast<double>(i);
    return radiusUndetermined(fit).value();
  };
  EXPECT_THAT(spanning(0.1), HasSubstr("spans only 5.73° of arc"));
  EXPECT_THAT(spanning(3), AllOf(HasSubstr("misread"), Not(HasSubstr("spans"))));
  EXPECT_THAT(spanning(NAN), AllOf(HasSubstr("misread"), Not(HasSubstr("—"))));
}

TEST(ArcFindings, SpanIsWhatTheWidestGapLeaves) {
  const Measurement measurement = test::usualMeasurement();
  for (const double middle : {90.0, 180.0, 270.0}) {
    const ArcFit fit =
        *fitArc(measurement, test::perfectArc(measurement, {0, 0, 400}, test::spread(9, 160, middle)));
    EXPECT_NEAR(arcSpan(fit).degrees(), 160, 1e-6) << middle;
  }
}

}  // namespace
}  // namespace alidade
