#include "core/simulation/simulate.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/random_source.h"
#include "core/observation/half_turn.h"
#include "core/session/entry.h"
#include "core/simulation/typed_angle.h"

namespace alidade {

namespace {

std::string rowName(const TrueGrossError& m) {
  return "axis " + std::to_string(m.axisDeg) + "°" +
         (m.repeat > 1 ? ", time " + std::to_string(m.repeat) : "") + ", round " + std::to_string(m.round) +
         ", point " + std::to_string(m.point) + ", face " + std::to_string(m.face);
}

/// Simulates the rows of a session in order.
class Simulator {
 public:
  enum class Noise { AsInTruth, None };

  Simulator(const Protocol& protocol, const Truth& truth, std::uint64_t seed, Noise noise)
      : m_protocol(protocol),
        m_truth(truth),
        m_random(seed),
        m_share(noise == Noise::None ? 0 : 1),
        m_step(noise == Noise::None ? Angle::fromArcseconds(1e-6) : truth.typingStep),
        m_plan(plannedRows(protocol)) {
    m_rows = m_plan.size() * protocol.axes.size();
  }

  Result<Session> simulate() {
    for (const TrueGrossError& error : m_truth.grossErrors)
      if (!plans(error)) return Problem{"the protocol has no row at " + rowName(error) + " to misread"};
    Session session;
    state(session);
    for (std::size_t i = 0; i < m_protocol.axes.size(); ++i)
      session.positions.push_back(position(m_protocol.axes[i], i));
    stateReference(session);
    const Examined examined = examine(session);
    if (!examined.problems.empty())
      return Problem{"these readings cannot be taken: " + examined.problems.front().text()};
    return session;
  }

 private:
  bool plans(const TrueGrossError& error) const {
    return error.repeat <= std::ranges::count(m_protocol.axes, error.axisDeg) &&
           std::ranges::find(m_plan, PlannedRow{error.round, error.point, error.face}) != m_plan.end();
  }

  /// Error of a reading with this σ. Draws even without noise, to keep the random sequence.
  Angle noise(Angle sigma) { return sigma * (m_share * m_random.normal()); }

  void state(Session& session) {
    const double distance = m_truth.distance + m_truth.sigmaDistance * m_share * m_random.normal();
    const auto arcseconds = [](Angle angle) {
      return shortestText(std::round(angle.arcseconds() * 1e6) / 1e6);
    };
    session.title = "Simulated session " + std::to_string(m_truth.seed);
    session.instrument.sigmaHorizontalArcsec = arcseconds(m_truth.sigmaHorizontal);
    session.instrument.sigmaVerticalArcsec = arcseconds(m_truth.sigmaVertical);
    session.instrument.sigmaZeroArcsec = arcseconds(m_truth.sigmaZero);
    if (m_protocol.slider) session.instrument.sigmaSliderArcsec = arcseconds(m_truth.sigmaSlider);
    session.geometry.distanceMm = shortestText(std::round(distance * 1e4) / 1e4);
    if (m_truth.sigmaDistance > 0) session.geometry.sigmaDistanceMm = shortestText(m_truth.sigmaDistance);
    session.geometry.radiusMm = shortestText(m_truth.nominalRadius);
    session.geometry.verticalCircle = keyOf(m_truth.verticalCircle);
    session.geometry.pointingZeros = "each";
    if (m_truth.plane == ArcPlane::Square) session.geometry.plane = "square";
  }

  /// Called after all readings: their noise must not depend on whether a reference is stated.
  void stateReference(Session& session) {
    if (!m_truth.sigmaReference) return;
    const double reference = m_truth.intersection + *m_truth.sigmaReference * m_share * m_random.normal();
    session.acceptance.referenceIntersectionMm = shortestText(std::round(reference * 1e4) / 1e4);
    session.acceptance.sigmaReferenceMm = shortestText(*m_truth.sigmaReference);
  }

  Position position(int axisDeg, std::size_t index) {
    m_repeat = static_cast<int>(std::count(
        m_protocol.axes.begin(), m_protocol.axes.begin() + static_cast<std::ptrdiff_t>(index) + 1, axisDeg));
    const PerfectReadings perfect(
        m_truth, axisDeg, m_truth.horizontalZero + m_protocol.circleShift * static_cast<double>(index));
    Position position;
    position.axisDeg = std::to_string(axisDeg);
    const bool inFull = m_truth.sightsZerosInFull;
    CircleReadings misread = perfect.zero(1, moment(m_plan.front()));
    if (const auto& wrong = m_truth.wrongZero;
        wrong && wrong->axisDeg == axisDeg && wrong->repeat == m_repeat) {
      misread.horizontal = misread.horizontal - wrong->horizontal;
      misread.vertical = misread.vertical - wrong->vertical;
    }
    const ZeroSighting first = zero(misread);
    position.zero.horizontal = first.horizontal;
    position.zero.vertical = first.vertical;
    if (inFull) position.zero.faceTwo = zero(perfect.zero(2, moment(m_plan.front())));
    for (std::size_t i = 0; i < m_plan.size(); ++i) {
      if (i == 0 || m_plan[i].point != m_plan[i - 1].point || m_plan[i].round != m_plan[i - 1].round)
        moveSlider(perfect, m_plan[i]);
      position.readings.push_back(reading(perfect, axisDeg, m_plan[i]));
    }
    if (!inFull) return position;
    --m_taken;  // the zeros are sighted at the moment of the last row
    position.zero.after = zero(perfect.zero(1, moment(m_plan.back())));
    position.zero.afterInTwo = zero(perfect.zero(2, moment(m_plan.back())));
    ++m_taken;
    return position;
  }

  ZeroSighting zero(const CircleReadings& circles) {
    const Angle horizontal = circles.horizontal + noise(m_truth.sigmaZero);
    return {typedOnCircle(horizontal, m_step),
            typedOnCircle(circles.vertical + noise(m_truth.sigmaZero), m_step)};
  }

  void moveSlider(const PerfectReadings& perfect, const PlannedRow& row) {
    m_place = plannedPlace(m_protocol, row.point) + m_truth.placeSpread * m_random.normal();
    m_slider = typedAngle(perfect.slider(m_place, moment(row)) + noise(m_truth.sigmaSlider), m_step);
  }

  Reading reading(const PerfectReadings& perfect, int axisDeg, const PlannedRow& row) {
    CircleReadings circles = perfect.target(m_place, row.face, moment(row));
    ++m_taken;
    const double factor = m_truth.noiseFactor;
    circles.horizontal = circles.horizontal + noise(m_truth.sigmaHorizontal * factor);
    circles.vertical = circles.vertical + noise(m_truth.sigmaVertical * factor);
    for (const TrueGrossError& m : m_truth.grossErrors) {
      if (m.axisDeg != axisDeg || m.repeat != m_repeat || PlannedRow{m.round, m.point, m.face} != row)
        continue;
      circles.horizontal = circles.horizontal + m.horizontal;
      circles.vertical = circles.vertical + m.vertical;
    }
    Reading reading;
    reading.point = std::to_string(row.point);
    reading.round = std::to_string(row.round);
    reading.face = std::to_string(row.face);
    reading.horizontal = typedOnCircle(circles.horizontal, m_step);
    reading.vertical = typedOnCircle(circles.vertical, m_step);
    if (m_protocol.slider) reading.slider = m_slider;
    return reading;
  }

  Moment moment(const PlannedRow& row) const {
    const double elapsed = m_rows > 1 ? static_cast<double>(m_taken) / static_cast<double>(m_rows - 1) : 0;
    return {elapsed, m_truth.jump && elapsed >= m_truth.jump->moment, row.round % 2 == 0,
            m_taken >= m_plan.size(), row.round};
  }

  const Protocol& m_protocol;
  const Truth& m_truth;
  RandomSource m_random;
  double m_share;  ///< factor of the noise, 0 or 1
  Angle m_step;
  std::vector<PlannedRow> m_plan;
  std::size_t m_rows = 0, m_taken = 0;
  int m_repeat = 1;  ///< the repeat of the position at its axis
  Angle m_place;
  std::string m_slider;
};

}  // namespace

PerfectReadings::PerfectReadings(const Truth& truth, int axisDeg, Angle horizontalZero)
    : m_truth(truth), m_errors(errorsOf(truth)), m_axisDeg(axisDeg), m_horizontalZero(horizontalZero) {
  if (truth.own) m_own = std::make_shared<OwnModel>(truth.own);
  if (!truth.jump) return;
  m_errors.set(ErrorTerm::HorizontalJump, truth.jump->horizontal.radians());
  m_errors.set(ErrorTerm::VerticalJump, truth.jump->vertical.radians());
}

Pointing PerfectReadings::pointing(int face, const Moment& moment) const {
  Pointing pointing;
  pointing.face = face;
  pointing.elapsed = moment.elapsed;
  pointing.jumpShare = moment.afterJump ? 1 : 0;
  pointing.isSetUpAgain = moment.isSetUpAgain;
  pointing.horizontalZero = m_horizontalZero.radians();
  pointing.circle = m_truth.verticalCircle;
  return pointing;
}

std::optional<OwnPlace> PerfectReadings::ownPlace(std::optional<Angle> s, int face,
                                                  const Moment& moment) const {
  if (!m_own) return std::nullopt;
  const bool isZenith = m_truth.verticalCircle == VerticalCircle::Zenith;
  const Angle elevation = isZenith ? Angle::fromDegrees(90) - m_truth.verticalZero : m_truth.verticalZero;
  return OwnPlace{.model = m_own.get(),
                  .row = {.s = s ? s->radians() : 0,
                          .t = moment.elapsed,
                          .leg = moment.wayBack ? -1.0 : 1.0,
                          .round = static_cast<double>(moment.round),
                          .face = face == 1 ? 1.0 : -1.0,
                          .position = halfTurnSign(m_axisDeg)},
                  .horizontalZero = m_horizontalZero.radians(),
                  .zeroElevation = elevation.radians(),
                  .circle = m_truth.verticalCircle,
                  .isZero = !s};
}

ArcPose<double> PerfectReadings::poseAt(Angle s) const {
  const double y = m_truth.axisHeight + halfTurnSign(m_axisDeg) * m_truth.intersection;
  double radius = m_truth.radius;
  if (const auto& harmonic = m_truth.harmonic)
    radius += harmonic->cosine * std::cos(harmonic->order * s.radians()) +
              harmonic->sine * std::sin(harmonic->order * s.radians());
  if (m_truth.foreign) radius += radiusBy(*m_truth.foreign, s);
  return {m_truth.centreX, y, radius, 0, 0, m_truth.sliderZero.radians()};
}

double PerfectReadings::arcAngle(Angle s) const {
  return arcAngleOf(s.radians(), m_axisDeg);
}

CircleReadings PerfectReadings::onCircles(const Direction<double>& direction, int face) const {
  const bool zenith = m_truth.verticalCircle == VerticalCircle::Zenith;
  const Angle e = Angle::fromRadians(direction.e);
  const CircleReadings faceOne{m_horizontalZero + Angle::fromRadians(direction.a),
                               zenith ? Angle::fromDegrees(90) - e : e};
  if (face == 1) return faceOne;
  return {faceOne.horizontal + Angle::fromDegrees(180),
          Angle::fromDegrees(zenith ? 360 : 180) - faceOne.vertical};
}

SpacePoint<double> PerfectReadings::inRoom(const SpacePoint<double>& target) const {
  const bool zenith = m_truth.verticalCircle == VerticalCircle::Zenith;
  const Angle elevation = zenith ? Angle::fromDegrees(90) - m_truth.verticalZero : m_truth.verticalZero;
  return roomFromZeroLine(target, m_truth.distance, elevation.radians(), m_truth.plane);
}

CircleReadings PerfectReadings::zero(int face, const Moment& moment) const {
  Pointing asDirection = pointing(face, moment);
  asDirection.isSetUpAgain = false;
  const std::optional<OwnPlace> own = ownPlace(std::nullopt, face, moment);
  asDirection.own = own ? &*own : nullptr;
  Moment thereOnly = moment;  // a zero is always approached as on the way there
  thereOnly.wayBack = false;
  return disturbed(circleDirection(m_errors, inRoom({0, 0, -m_truth.distance}), asDirection), face,
                   thereOnly);
}

CircleReadings PerfectReadings::disturbed(Direction<double> direction, int face, const Moment& moment) const {
  if (!m_truth.foreign) return onCircles(direction, face);
  const ForeignEffect& foreign = *m_truth.foreign;
  const Angle circle = onCircles(direction, face).horizontal;
  direction.a += azimuthBy(foreign, circle, moment.elapsed, moment.wayBack).radians();
  direction.e += elevationBy(foreign, Angle::fromRadians(direction.e), moment.elapsed).radians();
  return onCircles(direction, face);
}

CircleReadings PerfectReadings::target(Angle s, int face, const Moment& moment) const {
  const std::optional<OwnPlace> own = ownPlace(s, face, moment);
  SpacePoint<double> target =
      targetAt(m_errors, poseAt(s), m_truth.distance, arcAngle(s), m_axisDeg, own ? &*own : nullptr);
  Pointing taken = pointing(face, moment);
  taken.own = own ? &*own : nullptr;
  if (const auto& foreign = m_truth.foreign)
    target.z += halfTurnSign(m_axisDeg) * offPlaneBy(*foreign, s) - distanceBy(*foreign, moment.elapsed);
  return disturbed(circleDirection(m_errors, inRoom(target), taken), face, moment);
}

Angle PerfectReadings::slider(Angle s, const Moment& moment) const {
  const std::optional<OwnPlace> own = ownPlace(s, 1, moment);
  return Angle::fromRadians(
      observeSlider(m_errors, poseAt(s), arcAngle(s), m_axisDeg, m_truth.distance, own ? &*own : nullptr));
}

Result<Session> simulate(const Protocol& protocol, const Truth& truth, std::uint64_t seed) {
  return Simulator(protocol, truth, seed, Simulator::Noise::AsInTruth).simulate();
}

Result<Session> simulateWithoutNoise(const Protocol& protocol, const Truth& truth, std::uint64_t seed) {
  return Simulator(protocol, truth, seed, Simulator::Noise::None).simulate();
}

}  // namespace alidade
