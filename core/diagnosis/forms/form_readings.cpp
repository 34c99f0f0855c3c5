#include "core/diagnosis/forms/form_readings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/observation/half_turn.h"
#include "core/observation/perfect_theodolite.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double placeSize = 0.1 * std::numbers::pi / 180;  // rad
constexpr double perArcsecond = Angle::fromArcseconds(1).radians();

/// Builds the `FormReadings` of a session.
class SessionReadings {
 public:
  SessionReadings(const Leftover& leftover, const Measurement& measurement, const JointFit& fit)
      : m_leftover(leftover), m_measurement(measurement), m_fit(fit) {
    m_result.count = leftover.readings();
    m_result.face = each([&](Index i) { return rowOf(i).face == 1 ? 1.0 : -1.0; });
  }

  FormReadings take() {
    addCarriers();
    addArguments();
    addZeros();
    return std::move(m_result);
  }

 private:
  const Leftover& m_leftover;
  const Measurement& m_measurement;
  const JointFit& m_fit;
  FormReadings m_result;

  const LinearReading& at(Index i) const { return m_leftover.reading(i); }
  const ArcMeasurement& arcOf(Index i) const { return m_measurement.arcs[at(i).arc]; }
  const Sighting& rowOf(Index i) const { return arcOf(i).sightings[at(i).sighting]; }

  template <typename Value>
  VectorXd each(const Value& value) const {
    VectorXd values(m_result.count);
    for (Index i = 0; i < values.size(); ++i) values[i] = value(i);
    return values;
  }
  void set(FormCarrier carrier, VectorXd values) {
    if (values.squaredNorm() > 0) m_result.carriers[static_cast<std::size_t>(carrier)] = std::move(values);
  }
  void set(FormArgument argument, VectorXd values) {
    if (values.maxCoeff() > values.minCoeff())
      m_result.arguments[static_cast<std::size_t>(argument)] = std::move(values);
  }

  void addCarriers() {
    const VectorXd turn = each([&](Index i) { return halfTurnSign(arcOf(i).axisDeg); }),
                   off = m_leftover.column(ErrorTerm::PlaneOffset),
                   horizontal = perArcsecond * m_leftover.column(ErrorTerm::HorizontalJump),
                   vertical = upwards() * perArcsecond * m_leftover.column(ErrorTerm::VerticalJump);
    set(FormCarrier::Radial, m_leftover.column(Unknown::Kind::Radius));
    set(FormCarrier::Across, off);
    set(FormCarrier::X, m_leftover.column(Unknown::Kind::CentreX));
    set(FormCarrier::Y, m_leftover.column(Unknown::Kind::CentreY));
    set(FormCarrier::Z, off.cwiseProduct(turn));
    set(FormCarrier::Horizontal, horizontal);
    set(FormCarrier::Vertical, vertical);
    set(FormCarrier::Orientation, horizontal + vertical);
    const VectorXd slider = perArcsecond * m_leftover.column(Unknown::Kind::SliderZero);
    set(FormCarrier::Slider, slider);
    // If the target is displaced by δ along the arc, the theodolite sights s + δ/R and the slider reads s.
    set(FormCarrier::Tangential, slider * (-1 / (perArcsecond * m_measurement.nominalRadius)));
  }

  /// Sign of an upward change in `VerticalJump`, which is positive if the circle reading increases.
  double upwards() const { return m_measurement.verticalCircle == VerticalCircle::Zenith ? -1 : 1; }

  double sliderCoordinate(Index i) const {
    return sliderCoordinateOf(m_fit.arcAngles[at(i).arc][at(i).sighting], arcOf(i).axisDeg);
  }

  void addArguments() {
    using enum FormArgument;
    set(S, each([&](Index i) { return at(i).isZero ? 0 : sliderCoordinate(i); }));
    set(T, each([&](Index i) { return rowOf(i).elapsed; }));
    const VectorXd a = adjusted(ReadingKind::Horizontal), e = adjusted(ReadingKind::Vertical);
    set(Azimuth, a);
    set(Elevation, e);
    set(HorizontalCircle, each([&](Index i) {
          return arcOf(i).zeroHorizontal.radians() + a[i] + (rowOf(i).face == 1 ? 0 : std::numbers::pi);
        }));
    set(VerticalCircle, each([&](Index i) {
          return verticalCircleReading(e[i], rowOf(i).face, m_measurement.verticalCircle);
        }));
    set(Leg, each([&](Index i) { return at(i).isZero || rowOf(i).round % 2 == 1 ? 1.0 : -1.0; }));
    set(Round, each([&](Index i) { return static_cast<double>(rowOf(i).round); }));
    set(Face, m_result.face);
    set(Position, each([&](Index i) { return halfTurnSign(arcOf(i).axisDeg); }));
  }

  /// Adjusted azimuth, or elevation above the horizon, of each reading's row. A function of observed
  /// directions follows their noise.
  VectorXd adjusted(ReadingKind kind) const {
    std::vector<std::vector<double>> values;
    for (const ArcMeasurement& arc : m_measurement.arcs)
      for (auto& own = values.emplace_back(); const Sighting& row : arc.sightings)
        own.push_back(kind == ReadingKind::Horizontal ? row.a.radians()
                                                      : row.e.radians() + arc.zeroElevation.radians());
    for (const AdjustedReading& reading : m_fit.readings)
      if (reading.kind == kind) values[reading.arc][reading.sighting] -= reading.residual;
    return each([&](Index i) { return values[at(i).arc][at(i).sighting]; });
  }

  /// Does nothing if zeros are readings: a form then acts on the rows of the zeros.
  void addZeros() {
    for (Index i = 0; i < m_result.count; ++i)
      if (at(i).isZero) return;
    const auto set = [&](FormArgument of, const auto& value) {
      if (m_result.of(of).size() > 0) m_result.zeros[static_cast<std::size_t>(of)] = each(value);
    };
    set(FormArgument::T, [&](Index i) { return arcOf(i).zero.elapsed; });
    set(FormArgument::Azimuth, [](Index) { return 0.0; });
    set(FormArgument::Elevation, [&](Index i) { return arcOf(i).zeroElevation.radians(); });
    set(FormArgument::HorizontalCircle, [&](Index i) { return arcOf(i).zeroHorizontal.radians(); });
    set(FormArgument::VerticalCircle, [&](Index i) {
      return verticalCircleReading(arcOf(i).zeroElevation.radians(), 1, m_measurement.verticalCircle);
    });
  }
};

}  // namespace

FormReadings formReadings(const Leftover& leftover, const Measurement& measurement, const JointFit& fit) {
  return SessionReadings(leftover, measurement, fit).take();
}

double powerUnit(FormArgument of) {
  return of == FormArgument::T || of == FormArgument::Round ? 1 : std::numbers::pi / 18;
}

Eigen::Array2d formFunctions(const Form& form, double x) {
  const double at = form.numbers[0];
  switch (form.function) {
    case FormFunction::Harmonic: {
      const double turn = form.of == FormArgument::T ? 2 * std::numbers::pi * at * x : form.order * x;
      return {std::cos(turn), std::sin(turn)};
    }
    case FormFunction::Bump: {
      const double off = (x - at) / form.numbers[1];
      return {std::exp(-off * off / 2), 0};
    }
    case FormFunction::Step:
      return {x > at ? 1 : 0, 0};
    case FormFunction::Hinge:
      return {std::max(0.0, x - at) / powerUnit(form.of), 0};
    case FormFunction::Exponential:
      return {std::exp(-x / at), 0};
    case FormFunction::Power:
      return {std::pow(x / powerUnit(form.of), form.order), 0};
    case FormFunction::Hysteresis:
    case FormFunction::Walk:
    case FormFunction::PerPlace:
      break;
  }
  return {x, 0};
}

namespace {

Index functionsOf(const FormReadings& readings, const Form& form) {
  if (form.isFree()) return std::ssize(placesOf(readings, form));
  return form.function == FormFunction::Harmonic ? 2 : 1;
}

MatrixXd freeValues(const Form& form, const std::vector<double>& places, const VectorXd& x) {
  MatrixXd values(x.size(), std::ssize(places));
  for (Index i = 0; i < x.size(); ++i) values.row(i) = freeFunctions(form, places, x[i]).transpose();
  return values;
}

MatrixXd plainValues(const FormReadings& readings, const Form& form, const VectorXd& x) {
  MatrixXd values(x.size(), functionsOf(readings, form));
  // Neighbouring readings often have the same argument, so the functions are reused.
  Eigen::Array2d here = Eigen::Array2d::Zero();
  for (Index i = 0; i < values.rows(); ++i) {
    if (i == 0 || x[i] != x[i - 1]) here = formFunctions(form, x[i]);
    values.row(i) = here.head(values.cols()).matrix().transpose();
  }
  return values;
}

}  // namespace

std::vector<double> placesOf(const FormReadings& readings, const Form& form) {
  constexpr int walkParts = 12;
  std::vector<double> values, places;
  if (form.function == FormFunction::Walk) {
    for (int part = 0; part < walkParts; ++part) places.push_back((part + 0.5) / walkParts);
    return places;
  }
  const VectorXd &x = readings.of(form.of), &carrier = readings.of(form.carrier);
  for (Index i = 0; i < x.size(); ++i)
    if (carrier[i] != 0) values.push_back(x[i]);
  std::ranges::sort(values);
  for (const double value : values)
    if (places.empty() || value - places.back() >= placeSize) places.push_back(value);
  return places;
}

VectorXd freeFunctions(const Form& form, const std::vector<double>& places, double x) {
  VectorXd functions = VectorXd::Zero(std::ssize(places));
  if (places.empty()) return functions;
  const auto next = std::ranges::lower_bound(places, x);
  if (form.function == FormFunction::Walk) {
    functions.head(next - places.begin()).setConstant(1 / std::sqrt(static_cast<double>(places.size())));
    return functions;
  }
  auto nearest = next == places.end() ? next - 1 : next;
  if (nearest != places.begin() && x - nearest[-1] < std::abs(*nearest - x)) --nearest;
  if (std::abs(*nearest - x) < placeSize) functions[nearest - places.begin()] = 1;
  return functions;
}

Index columnsOf(const FormReadings& readings, const Form& form) {
  return functionsOf(readings, form) * (form.carrier == FormCarrier::Orientation ? 2 : 1);
}

MatrixXd formColumns(const FormReadings& readings, const Form& form) {
  return formColumns(readings, form, form.isFree() ? placesOf(readings, form) : std::vector<double>());
}

MatrixXd formColumns(const FormReadings& readings, const Form& form, const std::vector<double>& places) {
  const VectorXd& zero = readings.zeros[static_cast<std::size_t>(form.of)];
  const auto valuesAt = [&](const VectorXd& x) {
    return form.isFree() ? freeValues(form, places, x) : plainValues(readings, form, x);
  };
  MatrixXd values = valuesAt(readings.of(form.of));
  if (form.turnsWithFace) values = readings.face.asDiagonal() * values;
  if (zero.size() > 0 && isOfCircles(form.carrier)) values -= valuesAt(zero);
  if (form.carrier != FormCarrier::Orientation) return readings.of(form.carrier).asDiagonal() * values;
  MatrixXd both(values.rows(), 2 * values.cols());
  both << readings.of(FormCarrier::Horizontal).asDiagonal() * values,
      readings.of(FormCarrier::Vertical).asDiagonal() * values;
  return both;
}

}  // namespace alidade
