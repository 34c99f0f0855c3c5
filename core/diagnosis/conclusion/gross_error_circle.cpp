#include "core/diagnosis/conclusion/gross_error_circle.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/adjustment/gross_errors/visit_check.h"
#include "core/adjustment/numerics/arc_angle_step.h"
#include "core/observation/observe.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

struct Located {
  std::size_t arc = 0, sighting = 0;
};

std::optional<Located> locate(const Measurement& measurement, const ReadingDeviation& reading) {
  for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc) {
    if (measurement.arcs[arc].position != reading.position) continue;
    const auto& sightings = measurement.arcs[arc].sightings;
    const auto found = std::ranges::find(sightings, reading.row, &Sighting::row);
    if (found != sightings.end()) return Located{arc, static_cast<std::size_t>(found - sightings.begin())};
  }
  return std::nullopt;
}

bool isAlone(const Measurement& measurement, const Located& at) {
  const auto& sightings = measurement.arcs[at.arc].sightings;
  const Sighting& own = sightings[at.sighting];
  return !own.slider && std::ranges::count_if(sightings, [&](const Sighting& other) {
                          return other.point == own.point && other.round == own.round;
                        }) == 1;
}

/// Corrects a circle reading so that the sighting meets the arc; `correct` returns false if this fails.
class Correction {
 public:
  Correction(const Measurement& measurement, const ArcMeasurement& arc, const Circle& circle)
      : m_line(measurement, arc), m_distance(measurement.distance), m_circle(circle) {}

  bool correct(Sighting& sighting, ReadingKind kind, double phi) const {
    constexpr int steps = 30;
    constexpr double small = 1e-6, flat = 1e-3, found = 1e-11;  // rad; share of the arc's angular radius; rad
    const bool keepsA = kind == ReadingKind::Vertical;
    const double wanted = (keepsA ? sighting.a : sighting.e).radians();
    for (int i = 0; i < steps; ++i) {
      const Direction<double> seen = at(phi), next = at(phi + small);
      const double slope = ((keepsA ? next.a : next.e) - (keepsA ? seen.a : seen.e)) / small;
      if (std::abs(slope) < flat * m_circle.radius / m_distance) return false;
      const double off = wanted - (keepsA ? seen.a : seen.e);
      if (std::abs(off) < found) {
        (keepsA ? sighting.e : sighting.a) = Angle::fromRadians(keepsA ? seen.e : seen.a);
        return true;
      }
      phi += boundedArcAngleStep(off / slope);
    }
    return false;
  }

 private:
  ZeroLine m_line;
  double m_distance;
  Circle m_circle;

  Direction<double> at(double phi) const {
    return m_line.observe(targetOnArc(m_circle.x, m_circle.y, m_circle.radius, phi));
  }
};

}  // namespace

std::vector<ReadingDeviation> withLikelierCircles(const GapModel& model,
                                                  std::vector<ReadingDeviation> grossErrors) {
  const Measurement& measurement = *model.measurement;
  std::vector<std::size_t> open;
  JointFitOptions options = model.options;
  for (std::size_t i = 0; i < grossErrors.size(); ++i) {
    const std::optional<Located> at = locate(measurement, grossErrors[i]);
    if (!at || grossErrors[i].isZero || grossErrors[i].kind == ReadingKind::Slider ||
        !isAlone(measurement, *at))
      continue;
    open.push_back(i);
    for (const ReadingKind kind : {ReadingKind::Horizontal, ReadingKind::Vertical})
      options.without.push_back({at->arc, at->sighting, kind});
  }
  if (open.empty()) return grossErrors;
  const JointFit fit = fitJointly(measurement, model.starts, options);
  for (const std::size_t i : open) {
    const Located at = *locate(measurement, grossErrors[i]);
    const VisitCheck check(measurement, at.arc, options.without, fit, options);
    if (!check.canCheck()) continue;
    const Correction correction(measurement, measurement.arcs[at.arc], fit.circleOf(at.arc));
    const Sighting& read = measurement.arcs[at.arc].sightings[at.sighting];
    const double phi = model.fit->arcAngles[at.arc][at.sighting];
    Sighting horizontal = read, vertical = read;
    if (!correction.correct(horizontal, ReadingKind::Horizontal, phi) ||
        !correction.correct(vertical, ReadingKind::Vertical, phi))
      continue;
    const bool isHorizontal =
        check.agreement({horizontal}).logLikelihood > check.agreement({vertical}).logLikelihood;
    grossErrors[i].kind = isHorizontal ? ReadingKind::Horizontal : ReadingKind::Vertical;
    grossErrors[i].size =
        isHorizontal ? (read.a - horizontal.a).arcseconds() : (read.e - vertical.e).arcseconds();
  }
  return grossErrors;
}

}  // namespace alidade
