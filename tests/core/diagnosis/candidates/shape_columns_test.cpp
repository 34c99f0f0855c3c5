#include "core/diagnosis/candidates/shape_components.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <set>

#include "tests/support/full_leftover.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd;

const Measurement& measurement() {
  static const Measurement instance = test::trialMeasurement("full");
  return instance;
}

const JointFit& fit() {
  static const JointFit instance = fitSession(measurement()).joint;
  return instance;
}

const std::vector<ShapeComponent>& shapes() {
  static const std::vector<ShapeComponent> instance =
      shapeComponents(test::leftover(), measurement(), fit(), {});
  return instance;
}

bool holds(std::string_view id, std::string_view word) {
  return id.find(word) != std::string_view::npos;
}

// A pattern changes exactly the readings that its name states.
TEST(ShapeColumns, MoveWhatTheyAreNamedAfter) {
  for (const ShapeComponent& shape : shapes()) {
    const MatrixXd columns = shape.wholeColumns(test::leftover());
    std::set<ReadingKind> moved;
    for (Index i = 0; i < columns.rows(); ++i)
      if (columns.row(i).cwiseAbs().maxCoeff() > 0) moved.insert(test::leftover().reading(i).kind);
    std::set<ReadingKind> expected{ReadingKind::Horizontal, ReadingKind::Vertical};
    if (holds(shape.id(), "horizontal")) expected = {ReadingKind::Horizontal};
    if (holds(shape.id(), "vertical")) expected = {ReadingKind::Vertical};
    if (holds(shape.id(), "slider readings")) expected = {ReadingKind::Slider};
    EXPECT_EQ(moved, expected) << shape.id();
  }
}

ErrorSource sourceNamedBy(std::string_view id) {
  for (const std::string_view word : {"with time", "from round to round"})
    if (holds(id, word)) return ErrorSource::Time;
  for (const std::string_view word : {"with azimuth", "with elevation", "difference of the faces"})
    if (holds(id, word)) return ErrorSource::Instrument;
  return ErrorSource::Guideway;
}

TEST(ShapeColumns, ComeFromTheSourceTheirNameSays) {
  std::set<ErrorSource> found;
  for (const ShapeComponent& shape : shapes()) {
    EXPECT_EQ(shape.source(), sourceNamedBy(shape.id())) << shape.id();
    found.insert(shape.source());
  }
  EXPECT_EQ(found, (std::set{ErrorSource::Guideway, ErrorSource::Instrument, ErrorSource::Time}));
}

// Second to eighth harmonics of a scale that turns by s: cos ns and sin ns, times the effect of one unit on
// the slider's readings only. Patterns are stored in single precision.
TEST(ShapeColumns, FollowTheScaleInHarmonics) {
  const Eigen::VectorXd carrier = test::leftover().column(Unknown::Kind::SliderZero);
  std::multiset<int> orders;
  for (const ShapeComponent& shape : shapes()) {
    if (shape.id() != "slider readings along the scale" || shape.columns() != 2) continue;
    const MatrixXd columns = shape.wholeColumns(test::leftover());
    for (int order = 1; order <= 16; ++order) {
      MatrixXd waves = MatrixXd::Zero(columns.rows(), 2);
      for (Index i = 0; i < columns.rows(); ++i) {
        const LinearReading& reading = test::leftover().reading(i);
        const double phi = fit().arcAngles[reading.arc][reading.sighting];
        const double s = measurement().arcs[reading.arc].axisDeg == 0 ? phi : -phi;
        waves.row(i) << carrier[i] * std::cos(order * s), carrier[i] * std::sin(order * s);
      }
      const MatrixXd product = waves.transpose() * columns, square = waves.transpose() * waves;
      if (test::greatest(columns - waves * square.inverse() * product) < 1e-6) orders.insert(order);
    }
  }
  EXPECT_EQ(orders, (std::multiset<int>{2, 3, 4, 5, 6, 7, 8}));
}

}  // namespace
}  // namespace alidade
