#include "core/diagnosis/candidates/pattern.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/session/measurement.h"
#include "tests/support/full_leftover.h"
#include "tests/support/large_session.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixXf, Eigen::VectorXd;
using test::greatest, test::leftover;

using SharedCells = std::shared_ptr<const Cells>;

/// One cell for each row of the session, and one for each slider reading.
SharedCells rowByRow() {
  return std::make_shared<Cells>(leftover().readings(), [](Index i, Index j) {
    return leftover().reading(i).sighting == leftover().reading(j).sighting &&
           leftover().reading(i).visit == leftover().reading(j).visit;
  });
}

SharedCells visitByVisit() {
  return std::make_shared<Cells>(leftover().readings(), [](Index i, Index j) {
    return leftover().reading(i).visit == leftover().reading(j).visit;
  });
}

/// The column in the precision of carriers.
VectorXd column(ErrorTerm term) {
  return leftover().column(term).cast<float>().cast<double>();
}

std::shared_ptr<const Carrier> carrierOf(ErrorTerm term) {
  return std::make_shared<Carrier>(leftover(), leftover().column(term), rowByRow());
}

/// The columns of every function over the readings.
MatrixXd dense(const Pattern& pattern, const std::vector<VectorXd>& carriers) {
  const SharedCells cells = rowByRow();
  MatrixXd columns(leftover().readings(), 0);
  for (std::size_t p = 0; p < carriers.size(); ++p) {
    const MatrixXd functions = pattern.parts[p].functions.dense();
    for (Index f = 0; f < functions.cols(); ++f) {
      columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
      for (Index i = 0; i < columns.rows(); ++i)
        columns(i, columns.cols() - 1) =
            carriers[p][i] * functions(cells->ofReadings[static_cast<std::size_t>(i)], f);
    }
  }
  return columns;
}

MatrixXf someFunctions(Index cells, Index count) {
  return MatrixXf::NullaryExpr(cells, count, [](Index cell, Index f) {
    return std::cos(0.37F * static_cast<float>(cell) * static_cast<float>(f + 1));
  });
}

TEST(Pattern, IsKnownCellByCellAsOverTheReadings) {
  const auto radial = carrierOf(ErrorTerm::EllipticityCosine), sag = carrierOf(ErrorTerm::GravitySag);
  const Pattern pattern{{{radial, someFunctions(radial->cells(), 2)}, {sag, someFunctions(sag->cells(), 6)}}};
  const MatrixXd columns =
      dense(pattern, {column(ErrorTerm::EllipticityCosine), column(ErrorTerm::GravitySag)});
  ASSERT_EQ(pattern.columns(), columns.cols());
  const MatrixXd visible = leftover().visible(columns), gram = visible.transpose() * visible;
  EXPECT_LT(greatest(pattern.visibleGram(leftover()) - gram), 1e-12 * columns.squaredNorm());
  const VectorXd weights = VectorXd::LinSpaced(columns.cols(), -1, 2);
  EXPECT_LT(greatest(pattern.times(weights) - columns * weights), 1e-12 * columns.norm());
  const VectorXd any = leftover().observed().head(leftover().readings());
  EXPECT_LT(greatest(pattern.parts[1].functions.products(sag->gathered(any)) -
                     columns.rightCols(6).transpose() * any),
            1e-12 * columns.norm() * any.norm());
}

// Three groups and cells without a group, for visits with one cell and with several.
TEST(Pattern, OfGroupsIsThatOfTheirIndicatorFunctions) {
  for (const bool isOfVisits : {false, true}) {
    const SharedCells cells = isOfVisits ? visitByVisit() : rowByRow();
    const auto sag = std::make_shared<Carrier>(leftover(), leftover().column(ErrorTerm::GravitySag), cells);
    EXPECT_EQ(sag->squaresOutsideArcAngles(leftover()).size() > 0, isOfVisits);
    std::vector<Index> groups;
    MatrixXf functions = MatrixXf::Zero(sag->cells(), 3);
    for (Index cell = 0; cell < sag->cells(); ++cell) {
      groups.push_back(cell % 4 - 1);
      if (groups.back() >= 0) functions(cell, groups.back()) = 1;
    }
    MatrixXd columns(leftover().readings(), 3);
    for (Index f = 0; f < columns.cols(); ++f) columns.col(f) = sag->spread(functions.col(f).cast<double>());
    const MatrixXd visible = leftover().visible(columns), gram = visible.transpose() * visible;
    EXPECT_LT(greatest(sag->visibleGramOfGroups(leftover(), groups, 3) - gram),
              1e-12 * columns.squaredNorm());
    EXPECT_LT(greatest(Pattern{{{sag, functions}}}.visibleGram(leftover()) - gram),
              1e-12 * columns.squaredNorm());
  }
}

// Ten thousand cells are summed in three pieces.
TEST(Pattern, IsTheSameInPieces) {
  const Measurement measurement = *examine(test::largeSession(10'000)).measurement;
  const Leftover large(linearise(measurement, fitSession(measurement).joint));
  for (const bool isOfVisits : {false, true}) {
    const auto cells = std::make_shared<Cells>(large.readings(), [&](Index i, Index j) {
      return large.reading(i).visit == large.reading(j).visit &&
             (isOfVisits || large.reading(i).kind == large.reading(j).kind);
    });
    const auto carrier = std::make_shared<Carrier>(large, large.column(ErrorTerm::GravitySag), cells);
    const auto other = std::make_shared<Carrier>(large, large.column(ErrorTerm::Collimation), cells);
    const MatrixXf functions = someFunctions(carrier->cells(), 2);
    MatrixXd columns(large.readings(), 4);
    for (Index f = 0; f < 2; ++f) {
      columns.col(f) = carrier->spread(functions.col(f).cast<double>());
      columns.col(2 + f) = other->spread(functions.col(f).cast<double>());
    }
    const MatrixXd visible = large.visible(columns), gram = visible.transpose() * visible;
    const double digits = 1e-12 * columns.squaredNorm();
    EXPECT_LT(greatest(Pattern{{{carrier, functions}, {other, functions}}}.visibleGram(large) - gram),
              digits);
    EXPECT_LT(greatest(Pattern{{{carrier, functions}}}.visibleGram(large) - gram.topLeftCorner(2, 2)),
              digits);
  }
}

TEST(Pattern, MovesReadingsByOneSigmaInTheMean) {
  const auto sag = carrierOf(ErrorTerm::GravitySag);
  Pattern pattern{{{sag, someFunctions(sag->cells(), 3)}}};
  pattern.normalise();
  const MatrixXd columns = dense(pattern, {column(ErrorTerm::GravitySag)});
  const auto moved = static_cast<double>((columns.col(0).array() != 0).count());
  EXPECT_NEAR(columns.squaredNorm(), moved, 1e-9);
}

}  // namespace
}  // namespace alidade
