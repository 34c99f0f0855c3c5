#include "core/simulation/watched_session.h"

#include "core/simulation/typed_angle.h"

namespace alidade {

WatchedSession::WatchedSession(const Protocol& protocol, const Truth& truth, std::uint64_t seed)
    : m_protocol(protocol), m_truth(truth), m_random(seed) {
  m_rows = plannedRows(protocol).size() * protocol.axes.size();
  // The session has the statements (σ, geometry, …) of a whole session of this protocol and truth.
  if (const auto whole = simulate(protocol, truth, seed)) m_session = *whole;
  m_session.positions.clear();
}

PerfectReadings WatchedSession::perfect(int axisDeg) const {
  return {m_truth, axisDeg, m_truth.horizontalZero};
}

Moment WatchedSession::moment(int round) const {
  const double elapsed = m_rows > 1 ? static_cast<double>(m_taken) / static_cast<double>(m_rows - 1) : 0;
  return {elapsed, m_truth.jump && elapsed >= m_truth.jump->moment, round % 2 == 0,
          m_session.positions.size() > 1, round};
}

ZeroSighting WatchedSession::zero(int axisDeg) {
  const CircleReadings seen = perfect(axisDeg).zero(1, moment(1));
  const Angle horizontal = seen.horizontal + noise(m_truth.sigmaZero);
  return {typedOnCircle(horizontal, m_truth.typingStep),
          typedOnCircle(seen.vertical + noise(m_truth.sigmaZero), m_truth.typingStep)};
}

void WatchedSession::sight(int axisDeg, int round, int point, int face) {
  auto& positions = m_session.positions;
  if (positions.empty() || positions.back().axisDeg != std::to_string(axisDeg)) {
    Position position;
    position.axisDeg = std::to_string(axisDeg);
    const ZeroSighting first = zero(axisDeg);
    position.zero.horizontal = first.horizontal;
    position.zero.vertical = first.vertical;
    positions.push_back(std::move(position));
    m_point = 0;
  }
  const PerfectReadings perfect = this->perfect(axisDeg);
  if (point != m_point || round != m_round) {
    m_place = plannedPlace(m_protocol, point) + noise(m_truth.placeSpread);
    m_slider =
        typedAngle(perfect.slider(m_place, moment(round)) + noise(m_truth.sigmaSlider), m_truth.typingStep);
    m_point = point;
    m_round = round;
  }
  const CircleReadings seen = perfect.target(m_place, face, moment(round));
  ++m_taken;
  Reading reading;
  reading.point = std::to_string(point);
  reading.round = std::to_string(round);
  reading.face = std::to_string(face);
  reading.horizontal = typedOnCircle(seen.horizontal + noise(m_truth.sigmaHorizontal * m_truth.noiseFactor),
                                     m_truth.typingStep);
  reading.vertical =
      typedOnCircle(seen.vertical + noise(m_truth.sigmaVertical * m_truth.noiseFactor), m_truth.typingStep);
  if (m_protocol.slider) reading.slider = m_slider;
  positions.back().readings.push_back(std::move(reading));
}

void WatchedSession::sightZero() {
  if (m_session.positions.empty()) return;
  Position& position = m_session.positions.back();
  position.zero.after = zero(position.axisDeg == "0" ? 0 : 180);
}

std::optional<Measurement> WatchedSession::measurement() const {
  return examine(m_session).measurement;
}

}  // namespace alidade
