#include "core/diagnosis/candidates/second_derivatives.h"

#include <array>
#include <cassert>
#include <optional>

#include "core/observation/observe.h"

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd;

/// A node: two parameters, in plausible sizes, and the factors of its value in the differences 11, 12 and 22.
/// To second order f(1, 0) − f(0, 0) = f′ + f″/2; `secondDerivatives` subtracts 2f′ from 11 and 22.
struct Node {
  double first, second;
  std::array<double, 3> times;
};

constexpr std::array<Node, 4> nodes{
    {{0, 0, {-2, 1, -2}}, {1, 0, {2, -1, 0}}, {0, 1, {0, -1, 2}}, {1, 1, {0, 1, 0}}}};

using Targets = std::array<SpacePoint<double>, nodes.size()>;
using Differences = std::array<Direction<double>, 3>;

/// The forward model of one session, with one guideway for each node, changed by the effect of that node.
class BentGuideway {
 public:
  BentGuideway(const GapModel& model, const Effect& effect) : m_model(model) {
    const JointFit& fit = *model.fit;
    for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
      if (fit.unknowns[i].kind == Unknown::Kind::Error)
        (isOfGuideway(fit.unknowns[i].term) ? m_guideways.front() : m_instrument)
            .set(fit.unknowns[i].term, fit.values[i]);
    m_guideways.fill(m_guideways.front());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto add = [&](const EffectParameter& parameter, double sizes) {
        const double base = m_guideways[n][parameter.term];
        m_guideways[n].set(parameter.term, base + sizes * plausibleSize(parameter));
      };
      add(effect.parameters[0], nodes[n].first);
      add(effect.parameters[1], nodes[n].second);
    }
  }

  bool isOfPerfectInstrument() const { return m_instrument.isPerfect(); }

  Targets targets(const LinearReading& reading) const {
    const Circle circle = m_model.fit->circleOf(reading.arc);
    const ArcPose<double> pose{circle.x, circle.y, circle.radius, 0, 0, 0};
    const double phi = m_model.fit->arcAngles[reading.arc][reading.sighting];
    Targets targets;
    const Measurement& measurement = *m_model.measurement;
    const ArcMeasurement& arc = arcOf(reading);
    for (std::size_t n = 0; n < nodes.size(); ++n)
      targets[n] = roomFromZeroLine(targetAt(m_guideways[n], pose, measurement.distance, phi, arc.axisDeg),
                                    measurement.distance, arc.zeroElevation.radians(), measurement.plane);
    return targets;
  }

  Differences of(const Targets& targets, const LinearReading& reading) const {
    const Measurement& measurement = *m_model.measurement;
    const ArcMeasurement& arc = arcOf(reading);
    const Pointing pointing{.face = arc.sightings[reading.sighting].face,
                            .horizontalZero = arc.zeroHorizontal.radians(),
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

MatrixXd secondDerivatives(const GapModel& model, const Leftover& leftover, const Effect& effect) {
  assert(effect.response == Response::Bent);
  const BentGuideway guideway(model, effect);
  MatrixXd columns = MatrixXd::Zero(leftover.readings(), 3);
  Targets targets;
  Differences differences;
  for (Index v = 0; v < leftover.visits(); ++v) {
    const Leftover::Run visit = leftover.readingsOf(v);
    if (visit.length() > 0) targets = guideway.targets(leftover.reading(visit.first));
    std::optional<std::size_t> sighting;
    for (Index i = visit.first; i < visit.end; ++i) {
      const LinearReading& reading = leftover.reading(i);
      // The slider is read along its scale, independent of the target. The mark of a zero does not move.
      if (reading.kind == ReadingKind::Slider || reading.isZero || !reading.takesPart) continue;
      // A perfect instrument gives equal readings in both faces.
      if (!sighting || (*sighting != reading.sighting && !guideway.isOfPerfectInstrument()))
        differences = guideway.of(targets, reading);
      sighting = reading.sighting;
      for (std::size_t d = 0; d < differences.size(); ++d)
        columns(i, static_cast<Index>(d)) =
            (reading.kind == ReadingKind::Horizontal ? differences[d].a : differences[d].e) / reading.sigma;
    }
  }
  const EffectParameter &first = effect.parameters[0], &second = effect.parameters[1];
  columns.col(0) -= 2 * plausibleSize(first) * leftover.column(first.term);
  columns.col(2) -= 2 * plausibleSize(second) * leftover.column(second.term);
  if (!columns.allFinite()) columns.setZero();
  return columns;
}

}  // namespace alidade
