#include "core/simulation/simulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/adjustment/result/session_fit.h"
#include "core/base/angle_text.h"
#include "core/base/statistics.h"
#include "core/effects/catalogue.h"
#include "core/session/session_file.h"
#include "tests/support/trial_truth.h"

namespace alidade {
namespace {

using testing::HasSubstr;

/// The residuals of one position with truth and model given, after estimating only the random quantities: the
/// slider's places, and the errors of the pointing zero and of the slider's zero.
class Leftover {
 public:
  Leftover(const test::Trial& trial, const Truth& truth, const ArcMeasurement& arc)
      : m_measurement(trial.measurement), m_truth(truth), m_arc(arc) {
    for (std::size_t i = 0; i < arc.sightings.size(); ++i)
      m_visits[{arc.sightings[i].round, arc.sightings[i].point}].push_back(&arc.sightings[i]);
    for (const auto& [key, rows] : m_visits) m_places[key] = 10.0 * key.second * std::numbers::pi / 180;
    for (int round = 0; round < 6; ++round) {
      for (const auto& [key, rows] : m_visits) improvePlace(key);
      improveZeros();
    }
  }

  /// χ² in units of the simulated noise.
  double chiSquare() const {
    double sum = 0;
    for (const auto& [key, rows] : m_visits)
      for (const double v : residuals(key, m_places.at(key))) sum += v * v;
    return sum;
  }

  int degreesOfFreedom() const {
    int readings = 0;
    for (const auto& [key, rows] : m_visits)
      readings += static_cast<int>(residuals(key, m_places.at(key)).size());
    return readings - static_cast<int>(m_visits.size()) - (m_hasSlider ? 3 : 2);
  }

  /// Errors of α0 and β0 as read, in their σ.
  std::array<double, 2> zeroErrors() const {
    const double sigma = m_measurement.sigmaZeroHorizontal.radians();
    return {m_shift[0] / sigma, m_shift[1] / sigma};
  }

 private:
  using Visit = std::pair<int, int>;

  Moment momentOf(const Sighting& sighting) const {
    const double elapsed = sighting.elapsed;
    return {elapsed, m_truth.jump && elapsed >= m_truth.jump->moment};
  }

  /// Horizontal, vertical for each row, then the slider.
  std::vector<double> residuals(const Visit& key, double place) const {
    const PerfectReadings perfect(m_truth, m_arc.axisDeg, m_arc.zeroHorizontal);
    const double sighted = m_arc.zero.elapsed;
    const CircleReadings zero = perfect.zero(1, {sighted, m_truth.jump && sighted >= m_truth.jump->moment});
    std::vector<double> all;
    for (const Sighting* row : m_visits.at(key)) {
      const CircleReadings read = perfect.target(Angle::fromRadians(place), row->face, momentOf(*row));
      const double sign = row->face == 1 ? 1 : -1;
      const Angle turn = Angle::fromDegrees(row->face == 1 ? 0 : 180);
      const Angle a = wrapped(read.horizontal - turn - zero.horizontal);
      const Angle e =
          wrapped(Angle::fromDegrees(row->face == 1 ? 0 : 360) + zero.vertical * sign - read.vertical) * sign;
      double h = (row->a - a).radians() - m_shift[0], v = (row->e - e).radians() - m_shift[1];
      for (const TrueGrossError& m : m_truth.grossErrors)
        if (m.axisDeg == m_arc.axisDeg && m.round == row->round && m.point == row->point &&
            m.face == row->face) {
          h -= m.horizontal.radians();
          v += sign * m.vertical.radians();
        }
      const double sigma = m_truth.noiseFactor * m_measurement.sigmaHorizontal.radians();
      all.push_back(h / sigma);
      all.push_back(v / sigma);
    }
    const auto& slider = m_visits.at(key).front()->slider;
    if (slider)
      all.push_back((wrapped(*slider - perfect.slider(Angle::fromRadians(place))).radians() - m_shift[2]) /
                    m_measurement.sigmaSlider.radians());
    return all;
  }

  void improvePlace(const Visit& key) {
    double& place = m_places.at(key);
    const double step = 1e-5;
    const auto here = residuals(key, place), there = residuals(key, place + step);
    double top = 0, bottom = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      const double slope = (there[i] - here[i]) / step;
      top -= slope * here[i];
      bottom += slope * slope;
    }
    place += top / bottom;
  }

  void improveZeros() {
    std::array<double, 3> sum{};
    std::array<int, 3> count{};
    for (const auto& [key, rows] : m_visits) {
      const auto all = residuals(key, m_places.at(key));
      for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t kind = i == 2 * rows.size() ? 2 : i % 2;
        sum[kind] += all[i];
        ++count[kind];
      }
    }
    const double sigma = m_truth.noiseFactor * m_measurement.sigmaHorizontal.radians();
    for (const std::size_t kind : {0u, 1u}) m_shift[kind] += sigma * sum[kind] / count[kind];
    m_hasSlider = count[2] > 0;
    if (m_hasSlider) m_shift[2] += m_measurement.sigmaSlider.radians() * sum[2] / count[2];
  }

  const Measurement& m_measurement;
  const Truth& m_truth;
  const ArcMeasurement& m_arc;
  std::map<Visit, std::vector<const Sighting*>> m_visits;
  std::map<Visit, double> m_places;
  std::array<double, 3> m_shift{};
  bool m_hasSlider = false;
};

// An independent ray tracer turned a theodolite built from rotation matrices until it hit the target. With
// its truth, this program's readings differ from its readings by the added noise: χ² within its 0.01 %
// points, the pointing zeros within 4.5 σ.
TEST(Simulate, ReadsWhatTheRayTracerReads) {
  for (const test::Trial& trial : test::trials()) {
    const Truth truth = test::truthOf(trial);
    for (const ArcMeasurement& arc : trial.measurement.arcs) {
      SCOPED_TRACE(trial.id + " " + trial.kind + " at " + std::to_string(arc.axisDeg));
      const Leftover left(trial, truth, arc);
      const double tail = chiSquareUpperTail(left.chiSquare(), left.degreesOfFreedom()).value();
      EXPECT_GT(tail, 1e-4) << left.chiSquare() << " of " << left.degreesOfFreedom();
      EXPECT_LT(tail, 1 - 1e-4) << left.chiSquare() << " of " << left.degreesOfFreedom();
      for (const double error : left.zeroErrors()) EXPECT_LT(std::abs(error), 4.5);
    }
  }
}

Truth plainTruth() {
  Truth truth = drawTruth(7);
  truth.intersection = 1.25;
  return truth;
}

Session simulated(const std::string& protocol, const Truth& truth, std::uint64_t seed = 3) {
  return simulate(*protocolByName(protocol), truth, seed).operator*();
}

// Without effects the readings contain only noise. Summed over 40 sessions, χ² is within its 0.01 % points.
// Δd scatters as the fit says, its mean square within the 0.01 % points of 40 squared normal numbers.
TEST(Simulate, AddsTheStatedNoiseAndNoMore) {
  const Truth truth = plainTruth();
  for (const char* protocol : {"paper", "full"}) {
    double chiSquare = 0, squares = 0;
    int freedom = 0;
    constexpr int sessions = 40;
    for (int seed = 1; seed <= sessions; ++seed) {
      const Measurement measurement = test::measurementOf(simulated(protocol, truth, seed));
      const SessionFit fit = fitSession(measurement);
      chiSquare += fit.joint.chiSquare;
      freedom += fit.joint.degreesOfFreedom;
      const double sigma = fit.intersection->sigma;
      squares += std::pow((fit.intersection->value - truth.intersection) / sigma, 2);
    }
    EXPECT_GT(chiSquareUpperTail(chiSquare, freedom).value(), 1e-4) << protocol;
    EXPECT_LT(chiSquareUpperTail(chiSquare, freedom).value(), 1 - 1e-4) << protocol;
    EXPECT_GT(chiSquareUpperTail(squares, sessions).value(), 1e-4) << protocol;
    EXPECT_LT(chiSquareUpperTail(squares, sessions).value(), 1 - 1e-4) << protocol;
  }
}

TEST(Simulate, IsTheSameForTheSameSeedOnly) {
  const Truth truth = plainTruth();
  EXPECT_EQ(writeSession(simulated("full", truth)), writeSession(simulated("full", truth)));
  EXPECT_NE(writeSession(simulated("full", truth)), writeSession(simulated("full", truth, 4)));
}

TEST(Simulate, DrawsTheSameNoiseWithAndWithoutSliderReadings) {
  const Truth truth = plainTruth();
  Session with = simulated("paper-slider", truth), without = simulated("paper", truth);
  for (Position& position : with.positions)
    for (Reading& reading : position.readings) {
      EXPECT_NE(reading.slider, "");
      reading.slider.clear();
    }
  EXPECT_EQ(with.positions, without.positions);
}

TEST(Simulate, RoundsToTheTypingStepAndStaysOnTheCircle) {
  Truth truth = plainTruth();
  truth.horizontalZero = Angle::fromDegrees(0);  // so that half of the readings are reduced by 360°
  truth.typingStep = Angle::fromArcseconds(5);
  const Session session = simulated("two-face", truth);
  for (const Position& position : session.positions)
    for (const Reading& reading : position.readings)
      for (const std::string& text : {reading.horizontal, reading.vertical}) {
        const Angle angle = *parseAngle(text);
        EXPECT_GE(angle.degrees(), 0);
        EXPECT_LT(angle.degrees(), 360);
        const double steps = angle.arcseconds() / 5;
        EXPECT_NEAR(steps, std::round(steps), 1e-6) << text;
        EXPECT_THAT(text, testing::Not(HasSubstr("."))) << text;
      }
  EXPECT_TRUE(examine(session).problems.empty());
}

// A gross error changes only the row that it names, in the sense of the circle.
TEST(Simulate, MisreadsTheNamedRow) {
  Truth truth = plainTruth();
  const Session clean = simulated("full", truth);
  truth.grossErrors = {{180, 2, 5, 2, Angle::fromArcseconds(60), Angle::fromArcseconds(-600)}};
  const Session misread = simulated("full", truth);
  int changed = 0;
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t i = 0; i < clean.positions[p].readings.size(); ++i) {
      const Reading &before = clean.positions[p].readings[i], &after = misread.positions[p].readings[i];
      if (before == after) continue;
      ++changed;
      EXPECT_EQ(clean.positions[p].axisDeg + before.round + before.point + before.face, "180252");
      EXPECT_NEAR((*parseAngle(after.horizontal) - *parseAngle(before.horizontal)).arcseconds(), 60, 1e-6);
      EXPECT_NEAR((*parseAngle(after.vertical) - *parseAngle(before.vertical)).arcseconds(), -600, 1e-6);
    }
  EXPECT_EQ(changed, 1);
}

TEST(Simulate, RefusesToMisreadARowThatIsNotPlanned) {
  Truth truth = plainTruth();
  truth.grossErrors = {{0, 1, 5, 2, Angle::fromArcseconds(60), Angle()}};
  const Result<Session> session = simulate(*protocolByName("paper"), truth, 1);
  ASSERT_FALSE(session);
  EXPECT_THAT(session.problem().what, HasSubstr("axis 0°, round 1, point 5, face 2"));
}

TEST(Simulate, RefusesWhatCannotBeSighted) {
  Truth truth = plainTruth();
  truth.distance = 10;  // from 10 mm away, an arc of 400 mm extends beyond 80°
  EXPECT_FALSE(simulate(*protocolByName("paper"), truth, 1));
}

// The known parts of the truth are recovered: an elevation circle, a shifted circle, a distance with an
// error.
TEST(Simulate, IsReadBackByTheFit) {
  Truth truth = plainTruth();
  truth.verticalCircle = VerticalCircle::Elevation;
  truth.verticalZero = Angle();
  truth.sigmaDistance = 1;
  for (const char* protocol : {"there-and-back", "shifted-circle"}) {
    const Measurement measurement = test::measurementOf(simulated(protocol, truth));
    EXPECT_EQ(measurement.sigmaDistance, 1);
    EXPECT_NE(measurement.distance, truth.distance);
    const SessionFit fit = fitSession(measurement);
    EXPECT_LT(std::abs(fit.intersection->value - truth.intersection), 4 * fit.intersection->sigma);
    const double turn =
        wrapped(measurement.arcs[1].zeroHorizontal - measurement.arcs[0].zeroHorizontal).degrees();
    EXPECT_NEAR(turn, std::string(protocol) == "shifted-circle" ? 90 : 0, 0.01);
  }
}

// Readings without noise are rounded to 1e-6″, and taken at the same places as those with noise.
TEST(Simulate, ReadsWithoutNoiseWhatIsThere) {
  const Truth truth = drawTruth(9);
  const Protocol& protocol = *protocolByName("full");
  const Measurement perfect = *examine(*simulateWithoutNoise(protocol, truth, 9)).measurement;
  const Measurement read = *examine(*simulate(protocol, truth, 9)).measurement;
  const SessionFit fit = fitSession(perfect);
  EXPECT_LT(fit.joint.chiSquare, 1e-6);
  EXPECT_NEAR(fit.intersection->value, truth.intersection, 1e-6);
  for (std::size_t i = 0; i < read.arcs[1].sightings.size(); ++i)  // 5 σ of 2″
    EXPECT_NEAR(perfect.arcs[1].sightings[i].a.arcseconds(), read.arcs[1].sightings[i].a.arcseconds(),
                5 * 2 * 1.5);
}

// Rows are counted from 0: of 34 rows the one at 17/33 of the session is the first after a knock at that
// exact moment, and after one slightly earlier.
TEST(Simulate, KnockAtTheMomentOfARowComesBeforeIt) {
  const auto sessionKnockedAt = [](double row) {
    Truth truth = drawTruth(5);
    truth.jump = {
        .moment = row / 33, .horizontal = Angle::fromArcseconds(300), .vertical = Angle::fromArcseconds(300)};
    return *simulate(*protocolByName("paper"), truth, 5);
  };
  const Session at = sessionKnockedAt(17);
  EXPECT_EQ(at.positions[1].readings, sessionKnockedAt(16.5).positions[1].readings);
  EXPECT_NE(at.positions[1].readings, sessionKnockedAt(17.5).positions[1].readings);
}

/// The differences between two sessions of one seed in the horizontal circle, arcsec, position by position.
std::vector<double> meanShifts(const Measurement& one, const Measurement& other) {
  std::vector<double> shifts;
  for (std::size_t arc = 0; arc < one.arcs.size(); ++arc) {
    double sum = 0;
    for (std::size_t i = 0; i < one.arcs[arc].sightings.size(); ++i)
      sum += (other.arcs[arc].sightings[i].a - one.arcs[arc].sightings[i].a).arcseconds();
    shifts.push_back(sum / static_cast<double>(one.arcs[arc].sightings.size()));
  }
  return shifts;
}

// 0°, 180°, 0°: each position has its own zero, and an error meant for the second at 0° occurs only there.
TEST(Simulate, MeasuresAPositionAgain) {
  const Protocol& again = *protocolByName("again");
  Truth truth = drawTruth(4);
  const Measurement sound = test::measurementOf(*simulate(again, truth, 4));
  ASSERT_EQ(sound.arcs.size(), 3u);
  EXPECT_EQ(sound.arcs[2].axisDeg, 0);
  EXPECT_EQ(sound.arcs[2].repeat, 2);
  EXPECT_EQ(sound.rows, 3 * plannedRows(again).size());
  EXPECT_NE(sound.arcs[0].zeroHorizontal.radians(), sound.arcs[2].zeroHorizontal.radians());
  truth.wrongZero = {.axisDeg = 0, .horizontal = Angle::fromArcseconds(30), .vertical = {}, .repeat = 2};
  const std::vector<double> slipped = meanShifts(sound, test::measurementOf(*simulate(again, truth, 4)));
  EXPECT_NEAR(slipped[0], 0, 0.1);  // rounded to 0.1″
  EXPECT_NEAR(slipped[1], 0, 0.1);
  EXPECT_NEAR(slipped[2], 30, 0.1);
  truth.wrongZero.reset();
  truth.grossErrors = {
      {.axisDeg = 0, .point = 3, .horizontal = Angle::fromArcseconds(17 * 60), .vertical = {}, .repeat = 2}};
  const std::vector<double> misread = meanShifts(sound, test::measurementOf(*simulate(again, truth, 4)));
  EXPECT_NEAR(misread[0], 0, 0.1);
  EXPECT_NEAR(misread[2], 60, 0.1);
  truth.grossErrors.front().repeat = 3;
  const auto refused = simulate(again, truth, 4);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.problem().what.find("time 3"), std::string::npos);
}

}  // namespace
}  // namespace alidade
