#include "core/diagnosis/candidates/tilted_plane.h"

#include <array>
#include <optional>

#include "core/effects/catalogue.h"
#include "core/observation/observe.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd;

/// Where the plane is tilted to, in plausible sizes about x and y, and how often the differences xx, xy and
/// yy take the directions there: f(x, 0) − f(0, 0) is the first derivative and half the second, to third
/// order.
struct Node {
  double x, y;
  std::array<double, 3> times;
};

constexpr std::array<Node, 4> nodes{
    {{0, 0, {-2, 1, -2}}, {1, 0, {2, -1, 0}}, {0, 1, {0, -1, 2}}, {1, 1, {0, 1, 0}}}};

using Targets = std::array<SpacePoint<double>, nodes.size()>;
using Differences = std::array<Direction<double>, 3>;

/// The forward model of one session with its plane tilted to each node.
class TiltedPlane {
 public:
  explicit TiltedPlane(const GapModel& model) : m_model(model) {
    const JointFit& fit = model.fit;
    for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
      if (fit.unknowns[i].kind == Unknown::Kind::Error)
        (isOfGuideway(fit.unknowns[i].term) ? m_guideways.front() : m_instrument)
            .set(fit.unknowns[i].term, fit.values[i]);
    m_guideways.fill(m_guideways.front());
    const std::vector<EffectParameter>& tilts = effectById("plane_tilt")->parameters;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto tilt = [&](const EffectParameter& parameter, double sizes) {
        const double base = m_guideways[n][parameter.term];
        m_guideways[n].set(parameter.term, base + sizes * plausibleSize(parameter));
      };
      tilt(tilts[0], nodes[n].x);
      tilt(tilts[1], nodes[n].y);
    }
  }

  bool isOfPerfectInstrument() const { return m_instrument.isPerfect(); }

  Targets targets(const LinearReading& reading) const {
    const Circle circle = m_model.fit.circleOf(reading.arc);
    const ArcPose<double> pose{circle.x, circle.y, circle.radius, 0, 0, 0};
    const double phi = m_model.fit.arcAngles[reading.arc][reading.sighting];
    Targets targets;
    for (std::size_t n = 0; n < nodes.size(); ++n)
      targets[n] = targetAt(m_guideways[n], pose, m_model.measurement->distance, phi, arcOf(reading).axisDeg);
    return targets;
  }

  Differences of(const Targets& targets, const LinearReading& reading) const {
    const Measurement& measurement = *m_model.measurement;
    const ArcMeasurement& arc = arcOf(reading);
    const Pointing pointing{.face = arc.sightings[reading.sighting].face,
                            .horizontalZero = arc.zeroHorizontal.radians(),
                            .verticalZero = arc.zeroVertical.radians(),
                            .circle = measurement.verticalCircle,
                            .relation = measurement.relation};
    Differences differences{};
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const Direction<double> direction = circleDirection(m_instrument, targets[n], pointing);
      for (std::size_t d = 0; d < differences.size(); ++d) {
        differences[d].a += nodes[n].times[d] * direction.a;
        differences[d].e += nodes[n].times[d] * direction.e;
      }
    }
    return differences;
  }

 private:
  const GapModel& m_model;
  ErrorTerms<double> m_instrument;
  std::array<ErrorTerms<double>, nodes.size()> m_guideways;

  const ArcMeasurement& arcOf(const LinearReading& reading) const {
    return m_model.measurement->arcs[reading.arc];
  }
};

}  // namespace

MatrixXd secondDerivativesByPlaneTilt(const GapModel& model, const Leftover& leftover) {
  const TiltedPlane plane(model);
  MatrixXd columns = MatrixXd::Zero(leftover.readings(), 3);
  Targets targets;
  Differences differences;
  for (Index v = 0; v < leftover.visits(); ++v) {
    const Leftover::Run visit = leftover.readingsOf(v);
    if (visit.length() > 0) targets = plane.targets(leftover.reading(visit.first));
    std::optional<std::size_t> sighting;
    for (Index i = visit.first; i < visit.end; ++i) {
      const LinearReading& reading = leftover.reading(i);
      // The slider is read along the scale, whatever the plane does.
      if (reading.kind == ReadingKind::Slider || !reading.takesPart) continue;
      // A perfect instrument reads alike in both faces.
      if (!sighting || (*sighting != reading.sighting && !plane.isOfPerfectInstrument()))
        differences = plane.of(targets, reading);
      sighting = reading.sighting;
      for (std::size_t d = 0; d < differences.size(); ++d)
        columns(i, static_cast<Index>(d)) =
            (reading.kind == ReadingKind::Horizontal ? differences[d].a : differences[d].e) / reading.sigma;
    }
  }
  const std::vector<EffectParameter>& tilts = effectById("plane_tilt")->parameters;
  columns.col(0) -= 2 * plausibleSize(tilts[0]) * leftover.column(tilts[0].term);
  columns.col(2) -= 2 * plausibleSize(tilts[1]) * leftover.column(tilts[1].term);
  return columns;
}

}  // namespace alidade
