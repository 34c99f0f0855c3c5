#include "core/session/compensator.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/phrase.h"
#include "core/session/entry.h"

namespace alidade {

namespace {

constexpr double calibrationSigma = 5;  // arcsec, see compensator.h
constexpr double calibrationStale = 0.05, tiltsStale = 0.5, halfCorrectedStale = 0.1;
constexpr double freeIndex = 300;  // arcsec: beyond a compensator's range
constexpr double freeTilt = 3600;  // arcsec: keeps the equations regular
constexpr double leastOfUse = 30;  // arcsec, half of a plausible tilt: a tilt is used if its σ is smaller
constexpr double significant = 4;  // multiple of σ

/// The state of a switch, over all rows.
enum class Switch { Unknown, On, Off, Mixed };

Switch stateOf(const Measurement& measurement, bool Corrections::*isOn) {
  std::size_t on = 0, off = 0, unknown = 0;
  for (const ArcMeasurement& arc : measurement.arcs)
    for (const Sighting& sighting : arc.sightings)
      ++(!sighting.corrections ? unknown : (*sighting.corrections).*isOn ? on : off);
  if (on == 0 && off == 0) return Switch::Unknown;
  if (off == 0 && unknown == 0) return Switch::On;
  return on == 0 && unknown == 0 ? Switch::Off : Switch::Mixed;
}

/// All readings of the compensator as linear equations in tx, tz and the indices of cross and length, arcsec.
class TiltEquations {
 public:
  using Vector = Eigen::Vector4d;
  using Matrix = Eigen::Matrix4d;

  explicit TiltEquations(const Measurement& measurement)
      : m_sigma(measurement.sigmaCompensator.arcseconds()) {
    for (const ArcMeasurement& arc : measurement.arcs) {
      m_arcs.emplace_back();
      for (const Sighting& sighting : arc.sightings) add(sighting);
      if (m_arcs.back().empty()) m_arcs.pop_back();
    }
  }

  bool isEmpty() const { return m_arcs.empty(); }
  bool hasBothFaces() const { return m_hasFace[0] && m_hasFace[1]; }

  void solve() {
    Matrix normal = Matrix::Zero();
    Vector right = Vector::Zero();
    const double index = hasBothFaces() ? freeIndex : m_sigma;
    normal.diagonal() << std::pow(freeTilt, -2), std::pow(freeTilt, -2), std::pow(index, -2),
        std::pow(index, -2);
    for (const auto& arc : m_arcs) accumulate(arc, normal, right);
    const Eigen::LDLT<Matrix> solver(normal);
    m_values = solver.solve(right);
    m_covariance = solver.solve(Matrix::Identity());
    compareArcs();
  }

  Eigen::Vector2d tilt() const { return m_values.head<2>(); }
  /// The index that is larger in size.
  double index() const { return std::abs(m_values[2]) > std::abs(m_values[3]) ? m_values[2] : m_values[3]; }
  double range() const { return m_range; }
  /// σ of the range of the tilts between arcs, from the scatter within arcs.
  double sigmaOfRange() const { return m_sigmaOfRange; }
  double sigma(int i) const {
    const double ofIndex = hasBothFaces() ? index() : 0;
    return std::sqrt(m_scatter * m_scatter * m_covariance(i, i) + m_sigma * m_sigma + ofIndex * ofIndex +
                     m_range * m_range / 4);
  }

 private:
  struct Equation {
    Vector of;
    double read;
  };

  void add(const Sighting& sighting) {
    const TiltsRead byX = tiltsRead({1, 0}, sighting.a, sighting.face),
                    byZ = tiltsRead({0, 1}, sighting.a, sighting.face);
    if (sighting.tiltCross)
      m_arcs.back().push_back({{byX.cross, byZ.cross, 1, 0}, sighting.tiltCross->arcseconds()});
    if (sighting.tiltLength)
      m_arcs.back().push_back({{byX.length, byZ.length, 0, 1}, sighting.tiltLength->arcseconds()});
    if (sighting.tiltCross || sighting.tiltLength) m_hasFace[sighting.face == 2 ? 1 : 0] = true;
  }

  void accumulate(const std::vector<Equation>& equations, Matrix& normal, Vector& right) const {
    for (const Equation& equation : equations) {
      normal += equation.of * equation.of.transpose() / (m_sigma * m_sigma);
      right += equation.of * (equation.read / (m_sigma * m_sigma));
    }
  }

  /// Solves for the tilt of each arc separately, with the indices of all arcs. Sets the scatter within arcs
  /// and the range of the tilts.
  void compareArcs() {
    std::vector<Eigen::Vector2d> tilts;
    double squares = 0, freedom = -2, largest = 0;
    for (const auto& arc : m_arcs) {
      Matrix normal = Matrix::Zero();
      Vector right = Vector::Zero();
      normal.diagonal() << std::pow(freeTilt, -2), std::pow(freeTilt, -2), 1e12, 1e12;
      right.tail<2>() = 1e12 * m_values.tail<2>();
      accumulate(arc, normal, right);
      const Eigen::LDLT<Matrix> solver(normal);
      const Vector own = solver.solve(right);
      for (const Equation& equation : arc)
        squares += std::pow((equation.read - equation.of.dot(own)) / m_sigma, 2);
      freedom += static_cast<double>(arc.size()) - 2;
      const Matrix covariance = solver.solve(Matrix::Identity());
      largest = std::max({largest, covariance(0, 0), covariance(1, 1)});
      tilts.emplace_back(own.head<2>());
    }
    m_scatter = freedom > 0 ? std::max(1.0, std::sqrt(squares / freedom)) : 1;
    for (const Eigen::Vector2d& one : tilts)
      for (const Eigen::Vector2d& other : tilts) m_range = std::max(m_range, (one - other).norm());
    m_sigmaOfRange = m_scatter * std::sqrt(2 * largest);
  }

  double m_sigma;
  std::vector<std::vector<Equation>> m_arcs;
  std::array<bool, 2> m_hasFace{};
  Vector m_values = Vector::Zero();
  Matrix m_covariance = Matrix::Zero();
  double m_scatter = 1, m_range = 0, m_sigmaOfRange = 0;
};

class Knowledge {
 public:
  explicit Knowledge(const Measurement& measurement) : m_measurement(measurement) {}

  CompensatorKnowledge of() {
    for (const CorrectionSwitch& each : correctionSwitches)
      if (stateOf(m_measurement, each.isOn) == Switch::Mixed) m_answer.notes.mixed.push_back(each.key);
    ofTilt();
    const auto calibrated = [this](bool Corrections::*isOn, const char* effect) {
      if (stateOf(m_measurement, isOn) == Switch::On)
        add(effect, "", 0, calibrationSigma, Phrase::of("the instrument's correction by its own calibration"),
            calibrationStale);
    };
    calibrated(&Corrections::collimation, "collimation");
    calibrated(&Corrections::tiltingAxis, "trunnion_tilt");
    return std::move(m_answer);
  }

 private:
  static constexpr const char* aboutX = "tilt about x";
  static constexpr const char* aboutZ = "tilt about z";

  void add(const char* effect, const char* parameter, double value, double sigma, std::string from,
           double stale) {
    m_answer.known.push_back({.where = {.field = "readings.corrections"},
                              .effect = effect,
                              .parameter = parameter,
                              .unit = "arcsec",
                              .from = std::move(from),
                              .value = value,
                              .sigma = sigma,
                              .staleChance = stale});
  }

  void ofTilt() {
    const Switch inclination = stateOf(m_measurement, &Corrections::inclination);
    if (inclination == Switch::On) return takenOff();
    TiltEquations equations(m_measurement);
    if (equations.isEmpty() || inclination == Switch::Mixed) return;
    if (inclination == Switch::Unknown) {
      m_answer.notes.isInclinationUnknown = true;
      return;
    }
    equations.solve();
    const double sigma = m_measurement.sigmaCompensator.arcseconds();
    if (equations.hasBothFaces() && std::abs(equations.index()) > significant * sigma) {
      m_answer.notes.index = Angle::fromArcseconds(std::abs(equations.index()));
      return;
    }
    if (equations.range() > significant * std::hypot(sigma, equations.sigmaOfRange()))
      m_answer.notes.moved = Angle::fromArcseconds(equations.range());
    const std::string from = Phrase::of("tilts that the compensator read");
    const char* names[] = {aboutX, aboutZ};
    for (int i = 0; i < 2; ++i)
      if (equations.sigma(i) < leastOfUse)
        add("vertical_axis_tilt", names[i], equations.tilt()[i], equations.sigma(i), from, tiltsStale);
  }

  void takenOff() {
    const bool isOfBoth = stateOf(m_measurement, &Corrections::standingAxis) == Switch::On;
    const double stale = isOfBoth ? KnownNumber().staleChance : halfCorrectedStale;
    for (const char* name : {aboutX, aboutZ})
      add("vertical_axis_tilt", name, 0, m_measurement.sigmaCompensator.arcseconds(),
          Phrase::of("the instrument's compensator, which was on"), stale);
  }

  const Measurement& m_measurement;
  CompensatorKnowledge m_answer;
};

bool hasCompensatorData(const Sighting& sighting) {
  return sighting.tiltCross || sighting.tiltLength || sighting.corrections;
}

}  // namespace

TiltsRead tiltsRead(const AxisTilt& tilt, Angle a, int face) {
  const double side = face == 2 ? -1 : 1, sine = std::sin(a.radians()), cosine = std::cos(a.radians());
  return {side * (tilt.aboutX * sine - tilt.aboutZ * cosine),
          side * (-tilt.aboutX * cosine - tilt.aboutZ * sine)};
}

CompensatorKnowledge compensatorKnowledge(const Measurement& measurement) {
  const bool isAny = std::ranges::any_of(measurement.arcs, [](const ArcMeasurement& arc) {
    return std::ranges::any_of(arc.sightings, hasCompensatorData);
  });
  return isAny ? Knowledge(measurement).of() : CompensatorKnowledge();
}

}  // namespace alidade
