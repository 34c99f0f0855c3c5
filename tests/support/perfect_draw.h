#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "core/adjustment/monte_carlo/refit.h"
#include "core/observation/zero_line.h"
#include "tests/support/perfect_session.h"

namespace alidade::test {

// Draws with a known refit: the drawn values are the perfect readings of other circles.

/// Each σ is different, so that a confusion would show.
inline Measurement uncertainMeasurement() {
  Measurement measurement = usualMeasurement();
  measurement.sigmaVertical = Angle::fromArcseconds(3);
  measurement.sigmaSlider = Angle::fromArcseconds(20);
  measurement.sigmaZeroHorizontal = Angle::fromArcseconds(1);
  measurement.sigmaZeroVertical = Angle::fromArcseconds(4);
  measurement.sigmaDistance = 0.7;
  measurement.sigmaRadius = 0.3;
  return measurement;
}

/// `measurement` with perfect arcs on both circles, over the upper half at 0° and the lower at 180°; with
/// `sliders`, readings of a slider with its zero at 10°.
inline Measurement withPerfectArcs(Measurement measurement, const std::array<Circle, 2>& circles, int places,
                                   double spanDegrees, bool sliders = false) {
  measurement.arcs.clear();
  measurement.rows = 0;
  for (const int axisDeg : {0, 180}) {
    const std::vector<double> angles = spread(places, spanDegrees, axisDeg == 0 ? 90 : 270);
    ArcMeasurement& arc = measurement.arcs.emplace_back(
        perfectArc(measurement, circles[axisDeg == 0 ? 0 : 1], angles, axisDeg));
    for (Sighting& sighting : arc.sightings) {
      sighting.sequence = measurement.rows++;
      const Angle phi = Angle::fromRadians(angles[sighting.row]);
      if (sliders) sighting.slider = Angle::fromDegrees(10) + (axisDeg == 0 ? phi : -phi);
    }
  }
  setMoments(measurement);
  return measurement;
}

/// Adds a drift of the vertical circle: zenith readings grow over the session, so that e decreases. The drift
/// counts from the zero sighted with the first row of each position.
inline void addVerticalDrift(Measurement& measurement, Angle drift) {
  for (ArcMeasurement& arc : measurement.arcs) {
    // The zero, read as level, was actually higher by its drift.
    const Angle ofZero = drift * arc.sightings.front().elapsed;
    ArcMeasurement level = {}, asItStood = {};
    asItStood.zeroElevation = ofZero;
    for (Sighting& sighting : arc.sightings) {
      const Direction<double> seen =
          ZeroLine(measurement, asItStood).observe(ZeroLine(measurement, level).sightedPoint(sighting));
      sighting.a = Angle::fromRadians(seen.a);
      sighting.e = Angle::fromRadians(seen.e) + ofZero - drift * sighting.elapsed;
    }
  }
}

/// A measurement with its fit and its draws.
class FittedForDraws {
 public:
  explicit FittedForDraws(Measurement measurement)
      : m_measurement(std::move(measurement)),
        m_fit(fitSession(m_measurement)),
        m_plan(m_measurement, m_fit.noise) {}
  FittedForDraws(const FittedForDraws&) = delete;
  FittedForDraws& operator=(const FittedForDraws&) = delete;

  RefitTask task() const { return {m_measurement, m_fit, m_plan}; }

 private:
  Measurement m_measurement;
  SessionFit m_fit;
  DrawPlan m_plan;
};

/// A draw without noise, with only its scale.
inline Draw quietDraw(const RefitTask& task, double scale = 1) {
  Draw draw;
  task.plan.drawInto(draw, 1, 0);
  draw.scale = scale;
  for (double& normal : draw.normals) normal = 0;
  return draw;
}

/// The draw that turns the readings, L and R0 into those of `wanted`. The pointing zeros are drawn from the
/// seed, and the noise of the readings compensates for them.
inline Draw drawOf(const RefitTask& task, const Measurement& wanted, double scale, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const Measurement& read = task.fitted;
  Draw draw = quietDraw(task, scale);
  const auto inSigmas = [](double change, double sigma) { return sigma > 0 ? change / sigma : 0; };
  draw.normals[DrawPlan::distance] = inSigmas(wanted.distance - read.distance, read.sigmaDistance);
  draw.normals[DrawPlan::radius] = inSigmas(wanted.nominalRadius - read.nominalRadius, read.sigmaRadius);
  for (std::size_t arc = 0; arc < read.arcs.size(); ++arc) {
    double* zeros = &draw.normals[task.plan.zeros(arc)];
    zeros[0] = normal(random);
    zeros[1] = normal(random);
    const Angle zeroA = read.sigmaZeroHorizontal * zeros[0], zeroE = read.sigmaZeroVertical * zeros[1];
    // A drawn zero that makes e larger is lower, so the same readings then point lower in space.
    ArcMeasurement level = {}, lower = {};
    lower.zeroElevation = -zeroE;
    for (std::size_t i = 0; i < read.arcs[arc].sightings.size(); ++i) {
      const Sighting& from = read.arcs[arc].sightings[i];
      Sighting to = wanted.arcs[arc].sightings[i];
      const Direction<double> seen =
          ZeroLine(wanted, lower).observe(ZeroLine(wanted, level).sightedPoint(to));
      to.a = Angle::fromRadians(seen.a);
      to.e = Angle::fromRadians(seen.e);
      double* noise = &draw.normals[task.plan.readings(arc, i)];
      noise[0] = (to.a - from.a - zeroA).radians() / (read.sigmaHorizontal * scale).radians();
      noise[1] = (to.e - from.e - zeroE).radians() / (read.sigmaVertical * scale).radians();
      if (from.slider)
        noise[2] = (*to.slider - *from.slider).radians() / (read.sigmaSlider * scale).radians();
    }
  }
  return draw;
}

/// A draw whose readings have a vertical drift, which the model estimates. The prior of the drift is drawn at
/// the drift of the readings, since another value would bias the estimate.
class DrawnDrift {
 public:
  DrawnDrift(const std::array<Circle, 2>& read, const std::array<Circle, 2>& drawn, std::uint64_t seed)
      : m_fitted(modelled(read)) {
    constexpr double scale = 1.6, normal = -0.8;
    const Measurement& measurement = task().fitted;
    Measurement wanted = withPerfectArcs(measurement, drawn, places, spanDegrees);
    addVerticalDrift(wanted, Angle::fromRadians(estimatedTerms(measurement).at(0).priorSigma) * normal);
    m_draw = drawOf(task(), wanted, scale, seed);
    m_draw.normals[DrawPlan::firstTerm] = normal;
  }

  RefitTask task() const { return m_fitted.task(); }
  const Draw& draw() const { return m_draw; }

 private:
  static constexpr int places = 9;
  static constexpr double spanDegrees = 150;
  FittedForDraws m_fitted;
  Draw m_draw;

  static Measurement modelled(const std::array<Circle, 2>& read) {
    Measurement measurement = uncertainMeasurement();
    measurement.effects = {"vertical_drift"};
    return withPerfectArcs(std::move(measurement), read, places, spanDegrees);
  }
};

/// Δx and Δy of each arc for each draw.
inline std::vector<double> centresOf(Refit& refit, const RefitTask& task, const std::vector<Draw>& drawn) {
  std::vector<double> centres(drawn.size() * task.centres());
  refit.refit(drawn, centres);
  return centres;
}

}  // namespace alidade::test
