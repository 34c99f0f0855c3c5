#include "core/diagnosis/observability/look_alikes.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnosis/candidates/effect_components.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

/// The traces of the catalogue's effects in the readings of a session.
struct Traces {
  GapModel model;
  Leftover leftover{linearise(*model.measurement, *model.fit, model.options)};
  std::vector<EffectComponent> effects = effectsBeyond(model, leftover, {});

  explicit Traces(const std::string& protocol) : model(*modelOf(test::trialMeasurement(protocol))) {}

  const EffectComponent& of(std::string_view id) const {
    return *std::ranges::find(effects, id, &EffectComponent::id);
  }
  /// A mixture of two effects with a little of the actual noise.
  VectorXd mixed(const EffectComponent& one, const EffectComponent& other) const {
    return one.signature(leftover, VectorXd::LinSpaced(one.weights(), 2, -1)) +
           other.signature(leftover, VectorXd::Ones(other.weights())) + 0.1 * leftover.residual();
  }
};

/// Distance to the span of the columns; invisible columns are ignored.
double distanceFromSpan(const VectorXd& trace, const MatrixXd& columns) {
  MatrixXd shown(columns.rows(), 0);
  for (Index c = 0; c < columns.cols(); ++c) {
    if (columns.col(c).norm() < 1e-9) continue;
    shown.conservativeResize(Eigen::NoChange, shown.cols() + 1);
    shown.rightCols(1) = columns.col(c).normalized();
  }
  if (shown.cols() == 0) return trace.norm();
  return (trace - shown * shown.colPivHouseholderQr().solve(trace)).norm();
}

// A stretched or eccentric scale leaves no trace without slider readings. The reference uses columns instead
// of normal equations, which have half the digits: a millionth of the trace.
TEST(Trace, IsAsFarFromAnEffectAsFromItsSpan) {
  for (const char* protocol : {"paper", "full"}) {
    const Traces traces(protocol);
    for (const EffectComponent& one : traces.effects) {
      const VectorXd visible = traces.mixed(one, traces.of("trunnion_tilt"));
      const Trace trace(traces.leftover, visible);
      EXPECT_EQ(trace.length(), visible.norm());
      for (const EffectComponent& other : traces.effects) {
        if (other.response() != Response::Linear) continue;
        const double expected = distanceFromSpan(visible, other.visibleColumns(traces.leftover));
        EXPECT_NEAR(trace.differenceFrom(other), expected, 1e-5 * visible.norm())
            << protocol << ' ' << one.id() << ' ' << other.id();
      }
    }
  }
}

TEST(Trace, IsAsFarFromAllOrNothingAsFromTheNearerOfTheTwo) {
  const Traces traces("paper");
  const EffectComponent& relation = traces.of("vertical_angle_relation");
  ASSERT_EQ(relation.response(), Response::AllOrNothing);
  const VectorXd all = relation.visibleColumns(traces.leftover).col(0);
  for (const double share : {-1.0, 0.2, 0.7, 1.5, 3.0}) {
    const VectorXd visible = share * all + traces.leftover.residual();
    const double expected = std::min(visible.norm(), (visible - all).norm());
    EXPECT_NEAR(Trace(traces.leftover, visible).differenceFrom(relation), expected, 1e-9 * all.norm())
        << share;
  }
}

/// The best of all tilts up to twelve plausible sizes on a grid that is refined repeatedly.
double distanceFromBent(const VectorXd& trace, const EffectComponent& effect, const Leftover& leftover) {
  const MatrixXd columns = effect.visibleColumns(leftover);
  Vector2d best(0, 0);
  double least = trace.norm();
  for (double step = 0.5, reach = 12; step > 1e-5; reach = 2 * step, step /= 4) {
    const Vector2d centre = best;
    for (double u = -reach; u <= reach; u += step)
      for (double v = -reach; v <= reach; v += step) {
        const double x = centre[0] + u, y = centre[1] + v;
        const Eigen::Vector<double, 5> bent(x, y, x * x / 2, x * y, y * y / 2);
        const double apart = (trace - columns * bent).norm();
        if (apart >= least) continue;
        least = apart;
        best = {x, y};
      }
  }
  return least;
}

// The last grid has steps of 1e-5 of a plausible size. The distance is never below the smallest one. A few
// iterations from several starts may end near it, with a difference that is negligible at 3 σ and 4.2 σ.
TEST(Trace, IsAsFarFromWhatBendsAsFromTheNearestOfAllItsSizes) {
  for (const char* protocol : {"paper", "paper-slider"}) {
    const Traces traces(protocol);
    const EffectComponent& tilt = traces.of("plane_tilt");
    ASSERT_EQ(tilt.response(), Response::Bent);
    for (const Vector2d& size : {Vector2d(1.3, -0.4), Vector2d(-2, 0.5), Vector2d(0, 4), Vector2d(-3, -3)}) {
      const Trace held(traces.leftover, tilt.signature(traces.leftover, size));
      EXPECT_LT(held.differenceFrom(tilt), 1e-3 * held.length()) << protocol << ' ' << size.transpose();
      const VectorXd visible =
          tilt.signature(traces.leftover, size) + traces.mixed(tilt, traces.of("gravity_sag"));
      const double expected = distanceFromBent(visible, tilt, traces.leftover);
      const double found = Trace(traces.leftover, visible).differenceFrom(tilt);
      EXPECT_GT(found, expected - 1e-4 * visible.norm()) << protocol << ' ' << size.transpose();
      EXPECT_LT(found, expected + 0.1) << protocol << ' ' << size.transpose();
    }
  }
}

// 1e-8 of the length is 1e-16 of its square, beyond the precision of normal equations.
TEST(Trace, TellsWhatIsMuchNearerThanItIsLong) {
  const Traces traces("full");
  for (const char* id : {"collimation", "arc_lobing"}) {
    const EffectComponent& effect = traces.of(id);
    const MatrixXd columns = effect.visibleColumns(traces.leftover);
    const VectorXd own = columns * VectorXd::Constant(columns.cols(), 50);
    const VectorXd residual = traces.leftover.residual();
    const VectorXd apart = residual - columns * columns.colPivHouseholderQr().solve(residual);
    const VectorXd little = apart * (1e-8 * own.norm() / apart.norm());
    EXPECT_NEAR(Trace(traces.leftover, own + little).differenceFrom(effect), little.norm(),
                1e-2 * little.norm())
        << id;
  }
}

// For one number the cosine is that of the angle between two vectors, independent of their lengths and signs.
TEST(Trace, ComparesByTheAngle) {
  const Traces traces("two-face");
  const EffectComponent &drift = traces.of("vertical_drift"), &sag = traces.of("gravity_sag");
  const VectorXd a = drift.visibleColumns(traces.leftover).col(0),
                 b = sag.visibleColumns(traces.leftover).col(0);
  for (const double size : {0.1, 1.0, -20.0}) {
    const VectorXd visible = size * (a + 0.5 * b);
    const LookAlike like = Trace(traces.leftover, visible).compared(drift);
    const double cosine = std::abs(visible.dot(a)) / visible.norm() / a.norm();
    EXPECT_EQ(like.effect, "vertical_drift");
    EXPECT_NEAR(like.cosine, cosine, 1e-9);
    EXPECT_NEAR(like.difference, visible.norm() * std::sqrt(1 - cosine * cosine), 1e-9 * visible.norm());
  }
  const LookAlike ofNothing = Trace(traces.leftover, VectorXd::Zero(traces.leftover.rows())).compared(sag);
  EXPECT_EQ(ofNothing.cosine, 0);
  EXPECT_EQ(ofNothing.difference, 0);
}

}  // namespace
}  // namespace alidade
