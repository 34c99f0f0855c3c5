#include "core/adjustment/result/input_reliability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using Kind = Unknown::Kind;
using Change = std::function<void(Session&, double more)>;

constexpr double arcsecond = std::numbers::pi / 648000;

SessionFit fitOfEntered(const Session& session) {
  return fitSession(test::measurementOf(session));
}

InputReliability reliabilityOf(const Session& session, const Unknown& input) {
  const auto all = reliabilityOfInputs(test::measurementOf(session), fitOfEntered(session));
  const auto found = std::ranges::find(all, input, &InputReliability::input);
  EXPECT_NE(found, all.end());
  return found == all.end() ? InputReliability{} : *found;
}

/// The derivative of a result of the fit with respect to an entered value: from fits with a larger and a
/// smaller value.
double slope(const Session& session, double step, const Change& change,
             const std::function<double(const SessionFit&)>& figure) {
  const auto figureAt = [&](double more) {
    Session changed = session;
    change(changed, more);
    return figure(fitOfEntered(changed));
  };
  return (figureAt(step) - figureAt(-step)) / (2 * step);
}

double intersectionOf(const SessionFit& fit) {
  return fit.intersection->value;
}

void addArcseconds(std::string& angle, double more) {
  angle = formatDms(*parseAngle(angle) + Angle::fromArcseconds(more), 3, AngleSigns::Typewriter);
}

Change ofVerticalZero(std::size_t position) {
  return
      [=](Session& session, double more) { addArcseconds(session.positions[position].zero.vertical, more); };
}

Change ofHorizontalZero(std::size_t position) {
  return [=](Session& session, double more) {
    addArcseconds(session.positions[position].zero.horizontal, more);
  };
}

/// The paper's readings as an elevation circle would have them.
Session onElevationCircle() {
  Session session = test::paperSession();
  session.geometry.verticalCircle = "elevation";
  const auto turn = [](std::string& angle) {
    angle = formatDms(wrapped(Angle::fromDegrees(90) - *parseAngle(angle)), 3, AngleSigns::Typewriter);
  };
  for (Position& position : session.positions) {
    turn(position.zero.vertical);
    for (Reading& reading : position.readings) turn(reading.vertical);
  }
  return session;
}

/// Returns a session with 0° repeated, its zero read 6″ differently.
Session measuredAgain() {
  Session session = test::paperSession();
  session.positions.push_back(session.positions[0]);
  addArcseconds(session.positions[2].zero.vertical, 6);
  return session;
}

// A new fit with a slightly different entry changes Δd at the stated rate, in sign and size. Linear to 1e-3
// of the largest.
TEST(InputReliability, SaysWhatAnErrorDoesToTheIntersection) {
  for (const Session& session : {test::paperSession(), onElevationCircle(), measuredAgain()}) {
    SCOPED_TRACE(session.geometry.verticalCircle + std::to_string(session.positions.size()));
    for (std::size_t arc = 0; arc < session.positions.size(); ++arc) {
      const double vertical = slope(session, 5, ofVerticalZero(arc), intersectionOf),
                   horizontal = slope(session, 5, ofHorizontalZero(arc), intersectionOf);
      EXPECT_NEAR(reliabilityOf(session, {.kind = Kind::VerticalZero, .arc = arc}).perInput * arcsecond,
                  vertical, 1e-3 * std::abs(vertical));
      EXPECT_NEAR(reliabilityOf(session, {.kind = Kind::HorizontalZero, .arc = arc}).perInput * arcsecond,
                  horizontal, 1e-3 * std::abs(vertical));
    }
    const double distance = slope(
        session, 1,
        [](Session& changed, double more) { changed.geometry.distanceMm = shortestText(2405 + more); },
        intersectionOf);
    EXPECT_NEAR(reliabilityOf(session, {.kind = Kind::Distance}).perInput, distance,
                1e-3 * std::abs(distance));
  }
}

TEST(InputReliability, NothingChecksZerosAndDistance) {
  const Session session = test::paperSession();
  const auto inputs = reliabilityOfInputs(test::measurementOf(session), fitOfEntered(session));
  EXPECT_EQ(inputs.size(), 5u);
  for (const InputReliability& input : inputs) EXPECT_EQ(input.redundancy, 0);
}

// A repeated axis checks its zeros: the visible share of an error is the change of the adjusted zero relative
// to the entered one.
TEST(InputReliability, AnotherPositionChecksTheZero) {
  const Session session = measuredAgain();
  const double shown = slope(session, 5, ofVerticalZero(0), [](const SessionFit& fit) {
    return fit.joint.values[fit.joint.indexOf({.kind = Kind::VerticalZero, .arc = 0})] / arcsecond;
  });
  const InputReliability zero = reliabilityOf(session, {.kind = Kind::VerticalZero, .arc = 0});
  EXPECT_GT(zero.redundancy, 0.1);
  EXPECT_NEAR(zero.redundancy, std::abs(shown), 1e-3);
}

// The visible share of an error of R0 is the part that the adjusted radius does not follow.
TEST(InputReliability, TheReadingsCheckAKnownRadius) {
  Session session = test::paperSession();
  session.model.radius = "known";
  session.geometry.sigmaRadiusMm = "0.05";
  const Change ofRadius = [](Session& changed, double more) {
    changed.geometry.radiusMm = shortestText(400 + more);
  };
  const double followed = slope(session, 0.1, ofRadius, [](const SessionFit& fit) {
    return fit.joint.values[fit.joint.indexOf({.kind = Kind::Radius, .arc = Unknown::everyArc})];
  });
  const InputReliability radius = reliabilityOf(session, {.kind = Kind::Radius, .arc = Unknown::everyArc});
  EXPECT_GT(radius.redundancy, 0.1);
  EXPECT_NEAR(radius.redundancy, 1 - followed, 1e-3);
  const double moved = slope(session, 0.1, ofRadius, intersectionOf);
  EXPECT_NEAR(radius.perInput, moved, 1e-3 * std::abs(moved));
}

}  // namespace
}  // namespace alidade
