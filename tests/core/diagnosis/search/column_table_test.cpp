#include "core/diagnosis/search/column_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/candidates/gross_error_components.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/candidates/shape_components.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// A plane tilt, which is bent; patterns with many columns; jumps with two; readings with one.
class ColumnTableTest : public testing::TestWithParam<const char*> {
 protected:
  GapModel model = *modelOf(test::trialMeasurement(GetParam()));
  Leftover leftover{linearise(*model.measurement, *model.fit, model.options)};
  Candidates candidates = candidatesFor();
  ColumnTable table{leftover, candidates};

  /// Returns the turned columns of a component.
  MatrixXd turned(std::size_t component) const {
    const Index count = table.count(component);
    MatrixXd turns(count, count);
    for (Index c = 0; c < count; ++c) turns.col(c) = table.weights(component, VectorXd::Unit(count, c));
    return candidates[component].visibleColumns(leftover) * turns;
  }
  template <typename Check>
  void eachComponent(const Check& check) const {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      SCOPED_TRACE(std::to_string(i) + " " + std::string(candidates[i].id()));
      check(i);
    }
  }

 private:
  Candidates candidatesFor() const {
    Candidates all;
    all.add(jumpComponents(leftover), 1e-3);
    all.add(effectsBeyond(model, leftover, {}), 0.04);
    all.add(shapeComponents(leftover, *model.measurement, *model.fit, {}), 0.01);
    all.add(grossErrorComponents(leftover), 1e-3);
    return all;
  }
};

/// Tolerance for sums in a different order, and patterns in single precision: as in component_test.cpp.
void expectNear(const MatrixXd& some, const MatrixXd& other, double scale) {
  ASSERT_EQ(some.rows(), other.rows());
  ASSERT_EQ(some.cols(), other.cols());
  EXPECT_LT((some - other).cwiseAbs().maxCoeff(), 1e-9 * (1 + scale));
}

TEST_P(ColumnTableTest, HasTheColumnsOfAllComponentsInTurn) {
  Index first = 0, widest = 0;
  eachComponent([&](std::size_t i) {
    EXPECT_EQ(table.first(i), first);
    EXPECT_EQ(table.count(i), candidates[i].columns());
    first += candidates[i].columns();
    widest = std::max(widest, table.count(i));
  });
  EXPECT_EQ(table.size(), first);
  EXPECT_GT(widest, 5);
}

// A rotation leaves inner products between neighbouring columns only; bent components are not turned.
TEST_P(ColumnTableTest, KnowsTheInnerProductsOfTurnedColumns) {
  int bending = 0;
  eachComponent([&](std::size_t i) {
    const MatrixXd columns = turned(i), gram = columns.transpose() * columns;
    const double square = columns.squaredNorm();
    EXPECT_NEAR(square, candidates[i].gram().trace(), 1e-9 * (1 + square));
    expectNear(table.gram(i), gram, square);
    expectNear(table.squares().segment(table.first(i), table.count(i)), gram.diagonal(), square);
    const bool bends = candidates[i].response() == Response::Bent;
    bending += bends;
    if (bends) expectNear(columns, candidates[i].visibleColumns(leftover), 0);
    for (Index c = 0; c < table.count(i) && !bends; ++c) {
      const double next = c + 1 < table.count(i) ? gram(c, c + 1) : 0;
      EXPECT_NEAR(table.subdiagonal()[table.first(i) + c], next, 1e-9 * (1 + square));
      for (Index other = 0; other + 1 < c; ++other) EXPECT_NEAR(gram(other, c), 0, 1e-9 * (1 + square));
    }
  });
  EXPECT_EQ(bending, 1);
}

TEST_P(ColumnTableTest, HasTheProductsOfAllColumns) {
  const VectorXd& visible = leftover.residual();
  const VectorXd products = table.products(visible);
  ASSERT_EQ(products.size(), table.size());
  eachComponent([&](std::size_t i) {
    const MatrixXd columns = turned(i);
    expectNear(products.segment(table.first(i), table.count(i)), columns.transpose() * visible,
               columns.norm() * visible.norm());
  });
}

TEST_P(ColumnTableTest, HasTheProductsOfAllColumnsWithOneComponent) {
  for (std::size_t one = 0; one < candidates.size(); ++one) {
    if (table.count(one) < 2 || candidates[one].onlyRow() || one % 7 == 0) continue;
    const MatrixXd own = turned(one), products = table.productsOf(one);
    ASSERT_EQ(products.cols(), own.cols());
    eachComponent([&](std::size_t i) {
      if ((i + one) % 5 != 0 && i != one) return;
      const MatrixXd columns = turned(i);
      expectNear(products.middleRows(table.first(i), table.count(i)), columns.transpose() * own,
                 columns.norm() * own.norm());
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Protocols, ColumnTableTest, testing::Values("paper", "paper-slider"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace alidade
