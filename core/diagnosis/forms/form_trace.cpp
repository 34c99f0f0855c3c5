#include "core/diagnosis/forms/find_forms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace alidade {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr double radiansOfDegree = std::numbers::pi / 180;

/// A carrier with its own amplitudes: each circle for the orientation, otherwise the form's carrier.
struct Channel {
  FormCarrier carrier;
  bool isVertical;
};

std::vector<Channel> channelsOf(const Form& form) {
  if (form.carrier != FormCarrier::Orientation) return {{form.carrier, false}};
  return {{FormCarrier::Horizontal, false}, {FormCarrier::Vertical, true}};
}

/// The value of the form at `x`, mm or arcseconds.
double valueAt(const FoundForm& found, const Channel& channel, double x) {
  const VectorXd functions = found.form.isFree() ? freeFunctions(found.form, found.places, x)
                                                 : VectorXd(formFunctions(found.form, x).matrix());
  const std::size_t count = found.coefficients.size() / channelsOf(found.form).size();
  const std::size_t first = channel.isVertical ? count : 0;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += found.coefficients[first + i].value * functions[static_cast<Index>(i)];
  return sum;
}

/// The argument as reported: an angle in degrees, for the horizontal circle in 0…360°.
double displayedArgument(const Form& form, double x) {
  if (!form.isOfAngle()) return x;
  const double degrees = x / radiansOfDegree;
  return form.of == FormArgument::HorizontalCircle ? degrees - 360 * std::floor(degrees / 360) : degrees;
}

struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  double at(double share) const { return low + share * (high - low); }
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

class Tracer {
 public:
  Tracer(const FoundForms& found, const VectorXd& left, const Leftover& leftover,
         const Measurement& measurement, const FormReadings& readings)
      : m_found(found),
        m_left(left),
        m_leftover(leftover),
        m_measurement(measurement),
        m_readings(readings) {}

  FormTrace traceOf(const FoundForm& found) const {
    FormTrace trace{.sigma = std::numeric_limits<double>::infinity()};
    for (const Channel& channel : channelsOf(found.form)) addPoints(found, channel, trace);
    addCurve(found, trace);
    return trace;
  }

 private:
  const FoundForms& m_found;
  const VectorXd& m_left;
  const Leftover& m_leftover;
  const Measurement& m_measurement;
  const FormReadings& m_readings;

  bool counts(Index i) const { return m_leftover.reading(i).takesPart && !m_leftover.reading(i).isZero; }
  bool isOfSameRow(Index i, Index j) const {
    return m_leftover.reading(i).arc == m_leftover.reading(j).arc &&
           m_leftover.reading(i).sighting == m_leftover.reading(j).sighting;
  }

  void addPoints(const FoundForm& found, const Channel& channel, FormTrace& trace) const {
    constexpr double leastWeight = 0.04;  // share of the largest weight: σ is at most five times the least σ
    VectorXd carrier = m_readings.of(channel.carrier);
    if (found.form.turnsWithFace) carrier = carrier.cwiseProduct(m_readings.face);
    const VectorXd seen = m_leftover.outsideArcAngles(carrier).col(0);
    std::vector<std::pair<FormPoint, double>> all;
    double most = 0;
    for (Index first = 0, next = 0; first < m_readings.count; first = next) {
      double weight = 0, after = 0, heldOut = 0;
      for (; next < m_readings.count && isOfSameRow(first, next); ++next) {
        if (!counts(next)) continue;
        weight += seen[next] * seen[next];
        after += seen[next] * m_left[next];
        heldOut += seen[next] * (m_found.heldOutErrors.size() > 0 ? m_found.heldOutErrors[next] : 0);
      }
      if (!(weight > 0)) continue;
      most = std::max(most, weight);
      all.emplace_back(pointAt(found, channel, first, after / weight, heldOut / weight), weight);
    }
    for (const auto& [point, weight] : all)
      if (weight > leastWeight * most) trace.points.push_back(point);
    trace.sigma = std::min(trace.sigma, 1 / std::sqrt(most));
  }

  FormPoint pointAt(const FoundForm& found, const Channel& channel, Index i, double after,
                    double heldOut) const {
    const double x = m_readings.of(found.form.of)[i];
    const ArcMeasurement& arc = m_measurement.arcs[m_leftover.reading(i).arc];
    return {.position = arc.position,
            .row = arc.sightings[m_leftover.reading(i).sighting].row,
            .isVertical = channel.isVertical,
            .at = displayedArgument(found.form, x),
            .before = valueAt(found, channel, x) + after,
            .after = after,
            .heldOut = m_found.heldOutErrors.size() > 0 ? heldOut : std::numeric_limits<double>::quiet_NaN()};
  }

  static void addCurve(const FoundForm& found, FormTrace& trace) {
    constexpr int steps = 360;
    const std::vector<Channel> channels = channelsOf(found.form);
    Span span;
    for (const FormPoint& point : trace.points) span.include(point.at);
    for (int i = 0; i <= steps && !trace.points.empty(); ++i) {
      const double displayed = span.at(static_cast<double>(i) / steps);
      const double x = found.form.isOfAngle() ? displayed * radiansOfDegree : displayed;
      trace.curve.push_back(
          {displayed, valueAt(found, channels.front(), x), valueAt(found, channels.back(), x)});
    }
  }
};

}  // namespace

void addTraces(FoundForms& found, const VectorXd& left, const Leftover& leftover,
               const Measurement& measurement, const FormReadings& readings) {
  const Tracer tracer(found, left, leftover, measurement, readings);
  for (FoundForm& form : found.forms) form.trace = tracer.traceOf(form);
}

void addCleanRange(FoundForm& found, const FormReadings& readings) {
  constexpr int steps = 1000;
  constexpr double least = 0.05;  // share of the range: a shorter clean range is a zero crossing
  const Form& form = found.form;
  if (form.function == FormFunction::Harmonic || form.function == FormFunction::Hysteresis || form.isFree())
    return;
  const VectorXd &carrier = readings.of(form.carrier), &of = readings.of(form.of);
  Span span;
  for (Index i = 0; i < readings.count; ++i)
    if (carrier[i] != 0) span.include(of[i]);
  const auto isClean = [&](double x) {
    return std::ranges::all_of(channelsOf(form), [&](const Channel& channel) {
      return std::abs(valueAt(found, channel, x)) * readings.of(channel.carrier).cwiseAbs().maxCoeff() < 1;
    });
  };
  for (int i = 0, first = 0; i <= steps + 1; ++i) {
    if (i <= steps && isClean(span.at(static_cast<double>(i) / steps))) continue;
    if (i - 1 - first >= least * steps)
      found.cleanRange.push_back({displayedArgument(form, span.at(static_cast<double>(first) / steps)),
                                  displayedArgument(form, span.at(static_cast<double>(i - 1) / steps))});
    first = i + 1;
  }
}

}  // namespace alidade
