#include "core/observation/observe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "core/adjustment/joint/linearised.h"
#include "core/adjustment/result/session_fit.h"
#include "core/effects/catalogue.h"
#include "core/simulation/simulate.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using enum ErrorTerm;

// The situation of the derivatives: 17 places there and back, in both faces, with slider readings. One case
// has an elevation circle, the other a zenith circle. The instrument is 30 mm off the height of the axis. One
// plane is square to the zero, one is vertical. The horizontal circle is shifted between the positions, and
// every error term of the model is well away from zero. Effects of the user's own act on every carrier.
Measurement everythingAtOnce(VerticalCircle circle) {
  Truth truth = drawTruth(11);
  truth.verticalCircle = circle;
  const bool isZenith = circle == VerticalCircle::Zenith;
  truth.verticalZero = Angle::fromDegrees(isZenith ? 89.3 : 0.7);
  truth.plane = isZenith ? ArcPlane::Vertical : ArcPlane::Square;
  truth.sigmaDistance = 1;
  for (const Effect& effect : effectCatalogue())
    for (const EffectParameter& parameter : effect.parameters)
      if (parameter.term != VerticalAngleRelation)
        truth.effects.push_back({parameter.term, 1.5 * parameter.plausible});
  OwnEffect own{.id = "own",
                .formula =
                    "radial = A*cos(7*s)*leg; across = B*bump(s, 83°, 20°); slider = C*sin(4*s)\n"
                    "horizontal = D*cos(5*s)*face + E*sin(3*alpha); vertical = F*e*sin(2*s) + D*t^2"};
  for (const char* name : {"A", "B"}) own.parameters.push_back({name, "0.2", "mm"});
  for (const char* name : {"C", "D", "E", "F"}) own.parameters.push_back({name, "30", "arcsec"});
  std::vector<Problem> problems;
  truth.own = examineOwnEffects({own}, problems);
  for (const EffectParameter& parameter : truth.own->entries()[0].effect.parameters)
    truth.effects.push_back({parameter.term, 1.5 * parameter.plausible});
  Session session = *simulate(*protocolByName("shifted-circle"), truth, 11);
  session.ownEffects = {own};
  Measurement measurement = test::measurementOf(session);
  measurement.effects.push_back("own:own");
  for (const Effect& effect : effectCatalogue()) measurement.effects.emplace_back(effect.id);
  return measurement;
}

/// Computes one reading in plain doubles, the model's other instantiation, from a fit's values with some of
/// them changed.
class ReadingModel {
 public:
  ReadingModel(const Measurement& measurement, const JointFit& fit)
      : m_measurement(measurement), m_fit(fit) {}

  struct Change {
    Unknown unknown = {};
    double angle = 0;  ///< added to the arc angle, rad
    double by = 0;     ///< added to the unknown
  };

  double at(const LinearReading& reading, const Change& change) const {
    const ArcMeasurement& arc = m_measurement.arcs[reading.arc];
    const Sighting& sighting = arc.sightings[reading.sighting];
    const auto value = [&](const Unknown& unknown) {
      const std::size_t i = m_fit.indexOf(unknown);
      return (i < m_fit.values.size() ? m_fit.values[i] : 0) + (unknown == change.unknown ? change.by : 0);
    };
    ErrorTerms<double> errors;
    for (std::size_t t = 0; t < errorTermCount; ++t)
      errors.set(static_cast<ErrorTerm>(t),
                 value({.kind = Unknown::Kind::Error, .term = static_cast<ErrorTerm>(t)}));
    const auto ofArc = [&](Unknown::Kind kind) { return value({.kind = kind, .arc = reading.arc}); };
    using enum Unknown::Kind;
    const ArcPose<double> pose{ofArc(CentreX),        ofArc(CentreY),      ofArc(Radius),
                               ofArc(HorizontalZero), ofArc(VerticalZero), ofArc(SliderZero)};
    const double distance = m_measurement.distance + value({.kind = Distance});
    const double phi = m_fit.arcAngles[reading.arc][reading.sighting] + change.angle;
    const OwnPlace own = m_own.placeOf(m_measurement, arc, sighting, phi),
                   ownOfZero = m_own.zeroOf(m_measurement, arc);
    if (reading.kind == ReadingKind::Slider)
      return observeSlider(errors, pose, phi, arc.axisDeg, distance, &own);
    const auto inRoom = [&](const SpacePoint<double>& point, double elevation) {
      return roomFromZeroLine(point, distance, elevation, m_measurement.plane);
    };
    const double asRead = arc.zeroElevation.radians();
    const Direction<double> zero =
        circleDirection(errors, inRoom({0, 0, -distance}, asRead), pointing(arc, nullptr, ownOfZero));
    const double elevation = 2 * asRead - zero.e + pose.verticalZero;
    const SpacePoint<double> target =
        inRoom(targetAt(errors, pose, distance, phi, arc.axisDeg, &own), elevation);
    const Direction<double> sighted = circleDirection(errors, target, pointing(arc, &sighting, own));
    return reading.kind == ReadingKind::Horizontal ? sighted.a - zero.a - pose.horizontalZero
                                                   : sighted.e - asRead;
  }

 private:
  Pointing pointing(const ArcMeasurement& arc, const Sighting* sighting, const OwnPlace& own) const {
    Pointing pointing;
    pointing.own = &own;
    pointing.horizontalZero = arc.zeroHorizontal.radians();
    pointing.circle = m_measurement.verticalCircle;
    pointing.elapsed = arc.zero.elapsed;
    if (!sighting) return pointing;
    pointing.face = sighting->face;
    pointing.elapsed = sighting->elapsed;
    pointing.jumpShare = 1;
    pointing.isSetUpAgain = &arc != m_measurement.arcs.data();
    return pointing;
  }

  const Measurement& m_measurement;
  const JointFit& m_fit;
  OwnModel m_own{m_measurement.own};
};

class DerivativeTest : public testing::TestWithParam<VerticalCircle> {
 protected:
  Measurement measurement = everythingAtOnce(GetParam());
  SessionFit fit = fitSession(measurement);
  Linearised linear = linearise(measurement, fit.joint, {.terms = estimatedTerms(measurement)});
  ReadingModel model{measurement, fit.joint};

  /// Central differences over ±h and ±h/2, extrapolated to h = 0.
  double numeric(const LinearReading& reading, ReadingModel::Change step) const {
    const auto quotient = [&](double share) {
      ReadingModel::Change plus = step, minus = step;
      plus.by = share * step.by, plus.angle = share * step.angle;
      minus.by = -plus.by, minus.angle = -plus.angle;
      return (model.at(reading, plus) - model.at(reading, minus)) / (2 * share);
    };
    return (4 * quotient(0.5) - quotient(1)) / 3;
  }

  /// Both derivatives of every seventh reading, of all kinds and faces, per `h`. A difference of readings
  /// near 1 rad is rounded to some 1e-15, and so is `numeric`; h causes changes of some 1e-4 rad.
  void compare(const std::string& name, const Unknown& unknown, double h,
               const std::function<double(std::size_t)>& automatic) {
    double largest = 0;
    for (std::size_t i = 0; i < linear.readings.size(); i += 7) {
      const LinearReading& reading = linear.readings[i];
      const double expected = numeric(reading, {unknown, 0, h});
      largest = std::max(largest, std::abs(expected));
      EXPECT_NEAR(automatic(i) * reading.sigma * h, expected, 1e-7 * std::abs(expected) + 1e-13)
          << name << " of reading " << i;
    }
    EXPECT_GT(largest, 1e-9) << name << " moves no reading";
  }
};

TEST_P(DerivativeTest, OfEveryUnknownMeetsTheNumericOne) {
  for (std::size_t u = 0; u < linear.unknowns.size(); ++u) {
    const Unknown& unknown = linear.unknowns[u];
    const bool length = unknown.kind == Unknown::Kind::CentreX || unknown.kind == Unknown::Kind::CentreY ||
                        unknown.kind == Unknown::Kind::Radius || unknown.kind == Unknown::Kind::Distance;
    compare("unknown " + std::to_string(u), unknown, length ? 0.3 : 1e-4,
            [&](std::size_t i) { return linear.ofUnknown(i, u); });
  }
}

TEST_P(DerivativeTest, OfEveryErrorTermMeetsTheNumericOne) {
  const std::map<ErrorTerm, double> steps = {{VerticalAngleRelation, 0.01},
                                             {PlaneOffset, 0.3},
                                             {SetupShiftX, 0.3},
                                             {SetupShiftY, 0.3},
                                             {EllipticityCosine, 0.3},
                                             {EllipticitySine, 0.3},
                                             {LobingCosine, 0.3},
                                             {LobingSine, 0.3},
                                             {GravitySag, 0.3},
                                             {ArmSag, 0.3},
                                             {WarpCosine, 0.3},
                                             {WarpSine, 0.3},
                                             {PlaneSkew, 1e-3},
                                             {OwnGuideway, 0.3},
                                             {static_cast<ErrorTerm>(firstOwnTerm + 1), 0.3},
                                             {PlaneTiltX, 1e-3},
                                             {PlaneTiltY, 1e-3}};
  for (std::size_t t = 0; t < errorTermCount; ++t) {
    const auto term = static_cast<ErrorTerm>(t);
    if (isOwn(term) && !measurement.own->has(term)) continue;
    const auto step = steps.find(term);
    compare("term " + std::to_string(t), {.kind = Unknown::Kind::Error, .term = term},
            step == steps.end() ? 1e-4 : step->second, [&](std::size_t i) { return linear.ofTerm(i, term); });
  }
}

// Derivatives with respect to the arc angle are given by their direction within a visit. 1e-6: the slope by s
// of an own effect on the circles is taken at the direction that includes the effect.
TEST_P(DerivativeTest, ByTheArcAngleMeetsTheNumericOne) {
  std::map<std::size_t, std::vector<std::size_t>> visits;
  for (std::size_t i = 0; i < linear.readings.size(); ++i) visits[linear.readings[i].visit].push_back(i);
  for (const auto& [visit, readings] : visits) {
    std::vector<double> slopes;
    double squares = 0;
    for (const std::size_t i : readings) {
      slopes.push_back(numeric(linear.readings[i], {{}, 1e-4, 0}) / linear.readings[i].sigma);
      squares += slopes.back() * slopes.back();
    }
    for (std::size_t k = 0; k < readings.size(); ++k)
      EXPECT_NEAR(linear.readings[readings[k]].along, slopes[k] / std::sqrt(squares), 1e-6) << visit;
  }
}

INSTANTIATE_TEST_SUITE_P(Circles, DerivativeTest,
                         testing::Values(VerticalCircle::Zenith, VerticalCircle::Elevation),
                         [](const auto& circle) {
                           return circle.param == VerticalCircle::Zenith ? "Zenith" : "Elevation";
                         });

// The effect of each error of the guideway on the target, to first order, from its description alone:
// radially, across the plane, or downwards in space. R = 400 mm, s = φ at 0° and −φ at 180°.
TEST(Target, MovesAsTheErrorsOfTheGuidewayAreDescribed) {
  struct Shift {
    double x, y, z;
  };
  const ArcPose<double> pose{1, -2, 400, 0, 0, 0};
  for (const int axisDeg : {0, 180})
    for (const double phi : {0.4, 1.7, 2.9, -1.1}) {
      const double turn = axisDeg == 0 ? 1 : -1, s = turn * phi;
      const double c = std::cos(phi), d = std::sin(phi);
      const std::map<ErrorTerm, Shift> described = {
          {PlaneTiltX, {0, 0, 400 * d}},
          {PlaneTiltY, {0, 0, -400 * c}},
          {PlaneOffset, {0, 0, turn}},
          {PlaneSkew, {0, 0, turn * 400 * std::cos(s)}},
          {EllipticityCosine, {std::cos(2 * s) * c, std::cos(2 * s) * d, 0}},
          {EllipticitySine, {std::sin(2 * s) * c, std::sin(2 * s) * d, 0}},
          {LobingCosine, {std::cos(3 * s) * c, std::cos(3 * s) * d, 0}},
          {LobingSine, {std::sin(3 * s) * c, std::sin(3 * s) * d, 0}},
          {GravitySag, {0, -std::sin(s), 0}},
          {ArmSag, {c * d, -c * c, 0}},
          {WarpCosine, {0, 0, turn * std::cos(2 * s)}},
          {WarpSine, {0, 0, turn * std::sin(2 * s)}}};
      const SpacePoint<double> none = targetAt(ErrorTerms<double>(), pose, 2405.0, phi, axisDeg);
      for (const auto& [term, shift] : described) {
        // Second order is R h²/2, 2e-6 of the change; coordinates of 2405 mm are rounded to 5e-13 mm.
        const double h = 1e-5;
        ErrorTerms<double> errors;
        errors.set(term, h);
        const SpacePoint<double> moved = targetAt(errors, pose, 2405.0, phi, axisDeg);
        EXPECT_NEAR((moved.x - none.x) / h, shift.x, 3e-3) << static_cast<int>(term);
        EXPECT_NEAR((moved.y - none.y) / h, shift.y, 3e-3) << static_cast<int>(term);
        EXPECT_NEAR((moved.z - none.z) / h, shift.z, 3e-3) << static_cast<int>(term);
      }
    }
}

}  // namespace
}  // namespace alidade
