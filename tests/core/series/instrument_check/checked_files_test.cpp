#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/file_bytes.h"
#include "core/series/instrument_check/check_files.h"
#include "core/series/instrument_check/check_findings.h"
#include "core/series/instrument_check/check_record.h"
#include "core/series/instrument_check/instrument_check.h"

// Files of tests/reference/import. The expected figures are from plain loops over the files in another
// language, by the formulas of ISO 17123-3 and least squares of two unknowns. Angles in the files end at
// 0.1″, so the figures agree to all digits here.

namespace alidade::test {
namespace {

using testing::HasSubstr;

std::string contentOf(const std::string& name) {
  const Result<std::string> bytes = readFile(ALIDADE_REFERENCE_DIR "/import/" + name);
  return bytes ? *bytes : "";
}

Result<InstrumentCheck> checkOfFile(const std::string& name) {
  const std::string bytes = contentOf(name);
  const Result<CheckReadings> readings = readCheckFiles({{name, bytes}});
  if (!readings) return readings.problem();
  return checkReadings(*readings);
}

std::string refusalOf(const std::string& name) {
  const Result<InstrumentCheck> check = checkOfFile(name);
  return check ? "" : check.problem().text();
}

TEST(CheckedFile, OfTwoStationsWithoutNamesIsEvaluatedByStation) {
  const Result<InstrumentCheck> check = checkOfFile("check-stations-unnamed.csv");
  ASSERT_TRUE(check) << check.problem().text();
  ASSERT_EQ(check->stations.size(), 2U);
  const StationCheck &first = check->stations[0], &second = check->stations[1];
  EXPECT_EQ(first.station, "check-stations-unnamed (1)");
  EXPECT_NEAR(first.direction.s(), 0.39405, 1e-4);
  EXPECT_NEAR(first.vertical.s(), 0.25221, 1e-4);
  EXPECT_NEAR(second.direction.s(), 0.46667, 1e-4);
  EXPECT_NEAR(second.vertical.s(), 0.13123, 1e-4);
  EXPECT_NEAR(first.collimation.value, 5.27878, 1e-4);
  EXPECT_NEAR(first.collimation.u, 0.20988, 1e-4);
  EXPECT_NEAR(second.causes.tilt->other, 0.41317, 1e-4);
  EXPECT_NEAR(second.index.value, -3.12778, 1e-4);
  EXPECT_THAT(second.parted, HasSubstr("lines 20 and 25"));
}

TEST(CheckedFile, WithATargetElsewhereIsRefusedWithItsLines) {
  EXPECT_THAT(refusalOf("check-target-elsewhere.csv"),
              HasSubstr("lines 9 and 12: target “Q” is 2.0° from where it was sighted in lines 3 and 6"));
}

TEST(CheckedFile, WithAnOrientationThatJumpsIsRefused) {
  const std::string refusal = refusalOf("check-orientation-jumps.csv");
  EXPECT_THAT(refusal, HasSubstr("the collimation of target"));
  EXPECT_THAT(refusal, HasSubstr("departs by 5.0′"));
}

TEST(CheckedFile, OfDirectionsAloneHasNoFigureOfTheVerticalCircle) {
  const Result<InstrumentCheck> check = checkOfFile("check-directions-alone.csv");
  ASSERT_TRUE(check) << check.problem().text();
  const StationCheck& station = check->stations.front();
  EXPECT_NEAR(station.direction.s(), 0.70642, 1e-4);
  EXPECT_EQ(station.direction.degreesOfFreedom, 4);
  EXPECT_NEAR(station.collimation.value, 4.87778, 1e-4);
  EXPECT_NEAR(station.collimation.u, 0.17462, 1e-4);
  EXPECT_TRUE(std::isnan(station.index.value));
  EXPECT_EQ(station.vertical.degreesOfFreedom, 0);
  const InstrumentRecord record = checkedRecord(*check, {"T", "1", "2026-03-14", ""});
  EXPECT_EQ(record.known.size(), 1U) << "collimation";
  EXPECT_EQ(record.sigmaVerticalArcsec, "");
}

TEST(CheckedFile, HasOneCollimationInTableFindingAndRecord) {
  const Result<InstrumentCheck> check = checkOfFile("check-two-distances.csv");
  ASSERT_TRUE(check) << check.problem().text();
  const StationCheck& station = check->stations.front();
  ASSERT_TRUE(station.causes.lineOfSight);
  EXPECT_NEAR(station.causes.lineOfSight->other, 0.11696, 1e-5);
  EXPECT_NEAR(station.causes.lineOfSight->uOther, 0.00246, 1e-5);
  EXPECT_NEAR(station.causes.lineOfSight->correlation, -0.73480, 1e-4);
  EXPECT_NEAR(station.collimation.value, 8.00416, 1e-4) << "13.23″ without the offset; 8″ is true";
  EXPECT_NEAR(station.collimation.u, 0.14970, 1e-4);
  EXPECT_NEAR(check->collimation.value, station.collimation.value, 1e-9);
  std::string said;
  for (const Finding& finding : checkFindings(*check)) said += finding.text;
  EXPECT_THAT(said, HasSubstr("Corrected for this offset, the collimation is 8.00″ ± 0.15″"));
  const InstrumentRecord record = checkedRecord(*check, {"T", "1", "2026-03-14", ""});
  EXPECT_EQ(record.known.front().value, "8.004");
  EXPECT_EQ(record.known.front().sigma, "0.15");
  EXPECT_EQ(record.lineOfSight.offsetMm, "0.117");
  EXPECT_EQ(record.lineOfSight.sigmaMm, "0.0025");
  EXPECT_EQ(record.lineOfSight.correlation, "-0.7348");
}

}  // namespace
}  // namespace alidade::test
