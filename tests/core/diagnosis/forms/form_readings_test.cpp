#include "core/diagnosis/forms/form_readings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/diagnosis/gap/gap_model.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Kind = ForeignEffect::Kind;

constexpr double radian = std::numbers::pi / 180;

/// A session without noise and its closed model.
struct Unspoilt {
  Measurement measurement;
  GapModel model;
  Leftover leftover;
  FormReadings readings;

  explicit Unspoilt(const Truth& truth)
      : measurement(*examine(*simulateWithoutNoise(*protocolByName("full"), truth, 7)).measurement),
        model(*closedModelOf(*modelOf(measurement))),
        leftover(linearise(*model.measurement, *model.fit, model.options), model.options.terms),
        readings(formReadings(leftover, *model.measurement, *model.fit)) {}

  /// A reading as it was taken, rad.
  double observed(Index i) const {
    const LinearReading& at = leftover.reading(i);
    const Sighting& row = model.measurement->arcs[at.arc].sightings[at.sighting];
    if (at.kind == ReadingKind::Slider) return row.slider->radians();
    return at.kind == ReadingKind::Horizontal ? row.a.radians() : row.e.radians();
  }
};

/// The greatest difference between a form's columns and the readings of `disturbed` minus those of `truth`,
/// relative to the greatest reading. `constant`: constant part of the carrier, mm or arcsec. Zeros and
/// excluded readings do not count.
double greatestError(const Truth& truth, const Truth& disturbed, const Form& form, const VectorXd& amplitudes,
                     double constant = 0) {
  const Unspoilt before(truth), after(disturbed);
  const VectorXd expected =
      formColumns(before.readings, form) * amplitudes + constant * before.readings.of(form.carrier);
  double most = 0, error = 0;
  for (Index i = 0; i < before.readings.count; ++i) {
    const LinearReading& at = before.leftover.reading(i);
    if (at.isZero || !at.takesPart) continue;
    const double more = (after.observed(i) - before.observed(i)) / at.sigma;
    most = std::max(most, std::abs(more));
    error = std::max(error, std::abs(more - expected[i]));
  }
  EXPECT_GT(most, 1) << "the disturbance is to be seen";
  return error / most;
}

Truth truthWith(const ForeignEffect& effect) {
  Truth truth = drawTruth(7);
  truth.foreign = effect;
  return truth;
}

// If a later fit merges two places, the columns must still have one place for each amplitude found before.
TEST(FormColumns, AreOfThePlacesThatAFreeFormWasFoundWith) {
  const Unspoilt session(drawTruth(7));
  const Form form{.carrier = FormCarrier::Radial, .function = FormFunction::PerPlace, .of = FormArgument::S};
  const std::vector<double> places = placesOf(session.readings, form);
  ASSERT_GT(places.size(), 2u);
  FormReadings moved = session.readings;
  for (double& s : moved.arguments[static_cast<std::size_t>(FormArgument::S)])
    if (std::abs(s - places[1]) < 0.05 * radian) s = places[0] + 0.06 * radian;
  ASSERT_EQ(placesOf(moved, form).size() + 1, places.size());
  const Eigen::MatrixXd columns = formColumns(moved, form, places);
  EXPECT_EQ(columns.cols(), std::ssize(places));
  EXPECT_GT(columns.col(0).norm(), formColumns(session.readings, form).col(0).norm());
  EXPECT_EQ(columns.col(1).norm(), 0) << "nothing is there any more";
  EXPECT_EQ(formColumns(session.readings, form, places), formColumns(session.readings, form));
}

// Compares the columns (derivatives) with differences of the forward model with and without the effect.
TEST(FormColumns, AreWhatTheForwardModelReads) {
  const Truth truth = drawTruth(7);
  Form dent{.carrier = FormCarrier::Radial, .function = FormFunction::Bump, .of = FormArgument::S};
  dent.numbers = {80 * radian, 12 * radian};
  EXPECT_LT(
      greatestError(truth, truthWith({Kind::LocalDent, 0.05, 80, 12}), dent, VectorXd::Constant(1, 0.05)),
      1e-3);

  Form harmonic{.carrier = FormCarrier::Radial, .of = FormArgument::S, .order = 5};
  Truth wavy = truth;
  wavy.harmonic = FormHarmonic{.order = 5, .cosine = 0.03, .sine = -0.04};
  EXPECT_LT(greatestError(truth, wavy, harmonic, Eigen::Vector2d(0.03, -0.04)), 1e-3);

  Form warp{.carrier = FormCarrier::Across, .of = FormArgument::S, .order = 4};
  EXPECT_LT(greatestError(truth, truthWith({Kind::HighWarp, 0.3, 4, 90}), warp, Eigen::Vector2d(0.3, 0)),
            1e-3);

  Form circle{.carrier = FormCarrier::Horizontal, .of = FormArgument::HorizontalCircle, .order = 5};
  // Rows count from the zero as read, which has the error of the circle at the zero.
  const double zero = Unspoilt(truth).model.measurement->arcs[0].zeroHorizontal.radians();
  EXPECT_LT(greatestError(truth, truthWith({Kind::CirclePeriods, 20, 5, 0}), circle, Eigen::Vector2d(0, 20),
                          -20 * std::sin(5 * zero)),
            1e-3);

  Form settling{
      .carrier = FormCarrier::Orientation, .function = FormFunction::Exponential, .of = FormArgument::T};
  settling.numbers = {0.2, 0};
  EXPECT_LT(
      greatestError(truth, truthWith({Kind::Settling, 20, 0.2, 0}), settling, Eigen::Vector2d(20, 20), -20),
      1e-2);

  Form distance{
      .carrier = FormCarrier::Z, .function = FormFunction::Power, .of = FormArgument::T, .order = 1};
  EXPECT_LT(
      greatestError(truth, truthWith({Kind::DistanceRamp, 0.5, 0, 0}), distance, VectorXd::Constant(1, -0.5)),
      1e-2);

  Form backlash{.carrier = FormCarrier::Horizontal, .function = FormFunction::Step, .of = FormArgument::Leg};
  EXPECT_LT(
      greatestError(truth, truthWith({Kind::Backlash, 10, 0, 0}), backlash, VectorXd::Constant(1, -10), 10),
      1e-3)
      << "10″ on the way back are 10″ less a step there";
}

// A line of sight along the arc and a scale against it are the same.
TEST(FormColumns, AlongTheArcAreThoseOfTheSliderTurnedRound) {
  const Unspoilt session(drawTruth(7));
  const double perArcsecond = 400 * radian / 3600;
  EXPECT_LT(
      (session.readings.of(FormCarrier::Slider) + perArcsecond * session.readings.of(FormCarrier::Tangential))
          .norm(),
      1e-6 * session.readings.of(FormCarrier::Slider).norm());
}

}  // namespace
}  // namespace alidade
