#include "core/diagnosis/gap/leftover.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/diagnosis/gap/gap_model.h"
#include "tests/support/full_leftover.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using test::greatest;

/// Everything that the fit absorbs, including an arc angle for each visit, and the projector on its
/// complement.
struct Whole {
  MatrixXd projector;
  VectorXd observed;
  Index rank = 0, taking = 0;

  Whole(const Linearised& set, const std::vector<EstimatedTerm>& inModel) {
    const std::vector<std::size_t> unknowns = set.uncertainUnknowns();
    const std::vector<PriorRow> priors = set.priorRows(unknowns, inModel);
    const Index readings = std::ssize(set.readings), visits = static_cast<Index>(set.visits),
                rows = readings + std::ssize(priors);
    MatrixXd columns = MatrixXd::Zero(rows, visits + std::ssize(unknowns) + std::ssize(inModel));
    observed = VectorXd::Zero(rows);
    taking = std::ssize(priors);
    for (Index i = 0; i < readings; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const LinearReading& reading = set.readings[at];
      columns(i, reading.visit) = reading.along;
      observed[i] = reading.residual;
      taking += reading.takesPart;
      Index column = visits;
      for (const std::size_t u : unknowns) columns(i, column++) = set.ofUnknown(at, u);
      for (const EstimatedTerm& term : inModel) columns(i, column++) = set.ofTerm(at, term.term);
    }
    for (Index row = readings; const PriorRow& prior : priors) {
      columns(row, visits + static_cast<Index>(prior.column)) = prior.derivative;
      observed[row++] = prior.residual;
    }
    const VectorXd scale = columns.colwise().norm().cwiseMax(1e-300).cwiseInverse();
    columns *= scale.asDiagonal();
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
    rank = qr.rank();
    const MatrixXd taken = qr.householderQ() * MatrixXd::Identity(rows, rank);
    projector = MatrixXd::Identity(rows, rows) - taken * taken.transpose();
  }
};

/// The model; unless `plain` with two terms, an excluded row and two excluded readings.
GapModel modelBy(const std::string& protocol, bool plain) {
  GapModel model = *modelOf(test::trialMeasurement(protocol));
  if (plain) return model;
  model.options.terms = {{ErrorTerm::TrunnionTilt, 1e-4, 3e-5}, {ErrorTerm::EllipticitySine, 0.05}};
  model.options.without = {{0, 3, ReadingKind::Horizontal},
                           {0, 3, ReadingKind::Vertical},
                           {1, 5, ReadingKind::Vertical},
                           {1, 8, ReadingKind::Horizontal}};
  model.refit();
  return model;
}

// Sums of some hundred numbers in a different order agree except for a few last digits.
TEST(Leftover, IsWhatIsOutsideOfAllThatTheFitTakesUp) {
  for (const char* protocol : {"paper", "paper-slider", "two-face"})
    for (const bool plain : {true, false}) {
      SCOPED_TRACE(std::string(protocol) + (plain ? " plain" : ""));
      const GapModel model = modelBy(protocol, plain);
      const Linearised set = linearise(*model.measurement, *model.fit, model.options);
      const Leftover leftover(set, model.options.terms);
      const Whole whole(set, model.options.terms);
      ASSERT_EQ(leftover.rows(), whole.observed.size());
      const VectorXd residual = whole.projector * whole.observed;
      EXPECT_LT(greatest(leftover.residual() - residual), 1e-10);
      EXPECT_NEAR(leftover.chiSquare(), residual.squaredNorm(), 1e-10 * residual.squaredNorm());
      EXPECT_EQ(leftover.degreesOfFreedom(), whole.taking - whole.rank);
      for (Index i = 0; i < leftover.readings(); ++i)
        EXPECT_NEAR(leftover.redundancy(i), leftover.reading(i).takesPart ? whole.projector(i, i) : 0, 1e-10);
      MatrixXd columns = MatrixXd::Zero(leftover.rows(), 2);
      columns.col(0).head(leftover.readings()) = leftover.column(ErrorTerm::VerticalDrift) * 1e-4;
      columns.col(1) = VectorXd::LinSpaced(leftover.rows(), -1, 2);
      EXPECT_LT(greatest(leftover.visible(columns) - whole.projector * columns), 1e-10);
      const MatrixXd overReadings = columns.leftCols(1).topRows(leftover.readings());
      EXPECT_LT(greatest(leftover.visible(overReadings) - whole.projector * columns.leftCols(1)), 1e-10);
    }
}

// With exact zeros and distance the fit itself gives the leftover, from other equations. It ends 1e-9 σ from
// the minimum, where the residuals are accurate to some 1e-7.
TEST(Leftover, IsWhatTheFitLeavesWhereZerosAreExact) {
  Measurement measurement = test::trialMeasurement("full");
  const double known = Leftover(linearise(measurement, *modelOf(measurement)->fit)).chiSquare();
  measurement.sigmaZeroHorizontal = measurement.sigmaZeroVertical = Angle();
  measurement.sigmaDistance = 0;
  const GapModel model = *modelOf(measurement);
  const Leftover leftover(linearise(*model.measurement, *model.fit));
  EXPECT_EQ(leftover.rows(), leftover.readings());
  EXPECT_EQ(leftover.degreesOfFreedom(), model.fit->degreesOfFreedom);
  EXPECT_NEAR(leftover.chiSquare(), model.fit->chiSquare, 1e-7 * model.fit->chiSquare);
  EXPECT_LT(known, leftover.chiSquare());  // an uncertain zero absorbs a little
  for (Index i = 0; i < leftover.readings(); ++i)
    for (const AdjustedReading& reading : model.fit->readings)
      if (ReadingRef{reading.arc, reading.sighting, reading.kind} == readingRef(leftover, i)) {
        EXPECT_NEAR(leftover.residual()[i], reading.residual / reading.sigma, 1e-6);
        EXPECT_NEAR(leftover.redundancy(i), reading.redundancy, 1e-9);
      }
}

TEST(Leftover, SeesNothingOfWhatTheFitTakesUp) {
  const Leftover& leftover = test::leftover();
  for (const Unknown::Kind kind :
       {Unknown::Kind::CentreX, Unknown::Kind::CentreY, Unknown::Kind::Radius, Unknown::Kind::SliderZero}) {
    const VectorXd column = leftover.column(kind);
    ASSERT_GT(column.norm(), 0);
    EXPECT_LT(leftover.visible(column).norm(), 1e-11 * column.norm());
  }
  for (Index visit = 0; visit < leftover.visits(); visit += 7) {
    const Leftover::Run run = leftover.readingsOf(visit);
    VectorXd along = VectorXd::Zero(leftover.readings());
    for (Index i = run.first; i < run.end; ++i) along[i] = leftover.reading(i).along;
    EXPECT_NEAR(along.norm(), 1, 1e-12);
    EXPECT_LT(leftover.visible(along).norm(), 1e-11);
    EXPECT_LT(leftover.outsideArcAngles(along).norm(), 1e-12);
  }
}

// The slider's scale without slider readings and without prior knowledge.
TEST(Leftover, LosesNothingToWhatNoReadingSees) {
  const GapModel model = modelBy("paper", true);
  const Linearised set = linearise(*model.measurement, *model.fit);
  const Leftover without(set), with(set, {{ErrorTerm::SliderScale, std::numeric_limits<double>::infinity()}});
  EXPECT_EQ(with.degreesOfFreedom(), without.degreesOfFreedom());
  EXPECT_LT(greatest(with.residual() - without.residual()), 1e-10);
}

// Products of the derivatives, computed by kind of reading and by single readings.
TEST(Leftover, HasTheProductsOfEveryTerm) {
  const GapModel model = modelBy("paper-slider", false);
  const std::vector<ErrorTerm> some{ErrorTerm::VerticalIndex, ErrorTerm::SliderScale, ErrorTerm::GravitySag};
  const Leftover leftover(linearise(*model.measurement, *model.fit, model.options, some),
                          model.options.terms);
  const VectorXd any = VectorXd::LinSpaced(leftover.rows(), -2, 1), products = leftover.productsOfTerms(any);
  ASSERT_EQ(products.size(), static_cast<Index>(errorTermCount));
  for (Index t = 0; t < products.size(); ++t) {
    const VectorXd column = leftover.column(static_cast<ErrorTerm>(t));
    const double expected = column.dot(any.head(leftover.readings()));
    EXPECT_NEAR(products[t], expected, 1e-12 * column.norm() * any.norm()) << t;
  }
  EXPECT_NE(products[static_cast<Index>(ErrorTerm::SliderScale)], 0);
  EXPECT_EQ(products[static_cast<Index>(ErrorTerm::WarpSine)], 0);
}

// From a = atan(x/L) and sin e = y/|P|, differentiated by hand. Observed angles replace adjusted ones, since
// there is no noise. A slider zero enters the slider readings of its arc directly.
TEST(Leftover, ColumnsOfUnknownsAreThoseOfTheGeometry) {
  Measurement measurement = test::usualMeasurement();
  measurement.sigmaVertical = Angle::fromArcseconds(3);
  const double l = measurement.distance;
  measurement.arcs = {test::perfectArc(measurement, {1, 0.5, 400}, test::spread(7, 120)),
                      test::perfectArc(measurement, {1, -0.5, 400}, test::spread(9, 150, -90), 180)};
  for (Sighting& sighting : measurement.arcs[1].sightings)
    sighting.slider = Angle::fromDegrees(170 - 150.0 * static_cast<double>(sighting.row) / 8);
  const Leftover leftover(linearise(measurement, *modelOf(measurement)->fit));
  ASSERT_EQ(leftover.readings(), 2 * 7 + 3 * 9);
  const VectorXd byX = leftover.column(Unknown::Kind::CentreX), byY = leftover.column(Unknown::Kind::CentreY),
                 bySlider = leftover.column(Unknown::Kind::SliderZero);
  for (Index i = 0; i < leftover.readings(); ++i) {
    const LinearReading& reading = leftover.reading(i);
    const Sighting& row = measurement.arcs[reading.arc].sightings[reading.sighting];
    const double a = row.a.radians(), e = row.e.radians();
    const bool isA = reading.kind == ReadingKind::Horizontal, isE = reading.kind == ReadingKind::Vertical;
    const double ofX = isA   ? std::pow(std::cos(a), 2) / l
                       : isE ? -std::sin(e) * std::cos(e) * std::sin(a) * std::cos(a) / l
                             : 0,
                 ofY = isE ? std::pow(std::cos(e), 2) * std::cos(a) / l : 0;
    EXPECT_NEAR(byX[i] * reading.sigma * l, ofX * l, 1e-9) << i;
    EXPECT_NEAR(byY[i] * reading.sigma * l, ofY * l, 1e-9) << i;
    EXPECT_NEAR(bySlider[i] * reading.sigma, isA || isE ? 0 : 1, 1e-12) << i;
  }
}

}  // namespace
}  // namespace alidade
