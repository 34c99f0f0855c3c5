#include "core/diagnosis/conclusion/location.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/diagnosis/diagnose.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using testing::ElementsAre;

/// Parts of each division in their order.
std::vector<std::string> partsOf(const std::vector<GapShare>& where, const std::string& by) {
  std::vector<std::string> parts;
  for (const GapShare& share : where)
    if (share.by == by) parts.push_back(share.of);
  return parts;
}

double shareOf(const std::vector<GapShare>& where, const std::string& by, const std::string& of) {
  for (const GapShare& share : where)
    if (share.by == by && share.of == of) return share.share;
  return 0;
}

std::vector<GapShare> whereOf(const Protocol& protocol, const Truth& truth) {
  return diagnose(test::measurementOf(*simulate(protocol, truth, 3)))->where;
}

Truth with(ErrorTerm term, double size) {
  Truth truth = drawTruth(3);
  truth.effects = {{term, size}};
  return truth;
}

// Simulated effects are visible by 30 σ and more. Noise and minor explanations account for a few σ: less than
// a twentieth of the squares.
TEST(Location, FindsTheFrameOfWhatWasPutIn) {
  constexpr double most = 0.95;
  const Protocol& full = *protocolByName("full");
  const auto share = [&](const Truth& truth, const char* frame) {
    return shareOf(whereOf(full, truth), "frame", frame);
  };
  EXPECT_GT(share(with(ErrorTerm::HorizontalDrift, 40), "time"), most);
  EXPECT_GT(share(with(ErrorTerm::VerticalDrift, -40), "time"), most);
  EXPECT_GT(share(with(ErrorTerm::WarpCosine, 2), "guideway"), most);
  EXPECT_GT(share(with(ErrorTerm::EllipticitySine, 0.5), "guideway"), most);
  EXPECT_GT(share(with(ErrorTerm::SliderSine, 200), "guideway"), most);
  EXPECT_GT(share(with(ErrorTerm::Collimation, 40), "instrument"), most);
  EXPECT_GT(share(with(ErrorTerm::TrunnionTilt, -60), "instrument"), most);
  Truth knocked = drawTruth(3);
  knocked.jump = {
      .moment = 0.4, .horizontal = Angle::fromArcseconds(50), .vertical = Angle::fromArcseconds(-40)};
  EXPECT_GT(share(knocked, "time"), most);
  Truth noisy = drawTruth(3);
  noisy.noiseFactor = 4;
  EXPECT_GT(share(noisy, "noise"), most);
}

// An uncatalogued pattern has a frame too.
TEST(Location, FindsTheFrameOfAPatternWithoutAName) {
  Truth lobed = drawTruth(3);
  lobed.harmonic = FormHarmonic{.order = 7, .cosine = 0.2, .sine = 0.1};
  EXPECT_GT(shareOf(whereOf(*protocolByName("full"), lobed), "frame", "guideway"), 0.95);
}

/// Round 2, point 5 at 180°, face 2.
Truth misreadBy(double arcseconds) {
  Truth truth = drawTruth(3);
  truth.grossErrors = {{.axisDeg = 180,
                        .round = 2,
                        .point = 5,
                        .face = 2,
                        .horizontal = {},
                        .vertical = Angle::fromArcseconds(arcseconds)}};
  return truth;
}

// After least squares, an error e of a reading with redundancy r leaves the residual r e in this reading. All
// other squares together contain r (1 − r) e². The share of the reading is therefore r, at least 0.7 with two
// faces and a slider. The other face of the visit has most of the rest.
TEST(Location, FindsTheCellThatIsMisread) {
  const std::vector<GapShare> where = whereOf(*protocolByName("full"), misreadBy(120));
  EXPECT_GT(shareOf(where, "frame", "readings"), 0.95);
  EXPECT_GT(shareOf(where, "circle", "vertical"), 0.9);
  EXPECT_GT(shareOf(where, "position", "180"), 0.9);
  EXPECT_GT(shareOf(where, "round", "2"), 0.9);
  EXPECT_GT(shareOf(where, "sector", "30…60°"), 0.7);  // point 5 is at 50°
  EXPECT_GT(shareOf(where, "time", "quarter 4"), 0.9);
  EXPECT_GT(shareOf(where, "face", "2"), 0.7);
}

// The reference are the residuals of the fit itself with exact zeros and distance: Σ (v² − r)/σ² of each part
// over that of all parts. A trunnion tilt appears in every part.
TEST(Location, IsWhatTheResidualsOfTheFitSay) {
  Truth truth = with(ErrorTerm::TrunnionTilt, 60);
  truth.sigmaZero = Angle();
  const Measurement measurement = test::measurementOf(*simulate(*protocolByName("full"), truth, 3));
  const GapModel model = *modelOf(measurement);
  const Leftover leftover(linearise(*model.measurement, *model.fit, model.options));
  std::map<std::pair<std::string, std::string>, double> beyond;
  for (const AdjustedReading& reading : model.fit->readings) {
    const ArcMeasurement& arc = measurement.arcs[reading.arc];
    const Sighting& row = arc.sightings[reading.sighting];
    const double own = std::pow(reading.residual / reading.sigma, 2) - reading.redundancy;
    beyond[{"position", std::to_string(arc.axisDeg)}] += own;
    beyond[{"circle", std::string(nameOf(reading.kind))}] += own;
    beyond[{"face", std::to_string(row.face)}] += own;
    beyond[{"round", std::to_string(row.round)}] += own;
  }
  std::map<std::string, double> all;
  for (auto& [part, square] : beyond) all[part.first] += square = std::max(square, 0.0);
  const std::vector<GapShare> where = sharesOfReadings(leftover, measurement, *model.fit);
  for (const auto& [part, square] : beyond)
    EXPECT_NEAR(shareOf(where, part.first, part.second), square / all[part.first], 1e-6)
        << part.first << ' ' << part.second;
}

TEST(Location, ComesInTheOrderOfTheValues) {
  Protocol protocol = *protocolByName("there-and-back");
  protocol.rounds = 11;
  protocol.points = 6;
  protocol.step = Angle::fromDegrees(30);
  const std::vector<GapShare> where = whereOf(protocol, with(ErrorTerm::VerticalDrift, 30));
  EXPECT_THAT(partsOf(where, "frame"), ElementsAre("guideway", "instrument", "time", "readings", "noise"));
  EXPECT_THAT(partsOf(where, "position"), ElementsAre("0", "180"));
  EXPECT_THAT(partsOf(where, "round"), ElementsAre("1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11"));
  EXPECT_THAT(partsOf(where, "sector"),
              ElementsAre("0…30°", "30…60°", "60…90°", "90…120°", "120…150°", "150…180°"));
  EXPECT_THAT(partsOf(where, "time"), ElementsAre("quarter 1", "quarter 2", "quarter 3", "quarter 4"));
}

// Only both positions show what turns with the guideway.
TEST(Location, OnePositionDoesNotTellGuidewayFromInstrument) {
  Protocol protocol = *protocolByName("full");
  protocol.axes = {0};
  const std::vector<GapShare> where = whereOf(protocol, with(ErrorTerm::Collimation, 40));
  EXPECT_THAT(partsOf(where, "frame"), ElementsAre("guideway or instrument", "time", "readings", "noise"));
  EXPECT_GT(shareOf(where, "frame", "guideway or instrument"), 0.95);
}

}  // namespace
}  // namespace alidade
