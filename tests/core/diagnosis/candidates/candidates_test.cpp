#include "core/diagnosis/candidates/candidates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/candidates/gross_error_components.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "tests/support/full_leftover.h"

namespace alidade {
namespace {

using test::leftover;

Candidates ofThreeKinds() {
  Candidates candidates;
  candidates.add(effectComponents(leftover(), {}), 0.04);
  candidates.add(jumpComponents(leftover()), 1e-3, {.offered = 2, .oneAtMost = true});
  candidates.add(std::vector<JumpComponent>(), 1);
  candidates.add(grossErrorComponents(leftover()), 1e-4, {.offered = 4});
  return candidates;
}

// 19 effects, a jump before each of 136 rows except the first, and every reading.
TEST(Candidates, AreNumberedThrough) {
  const Candidates candidates = ofThreeKinds();
  ASSERT_EQ(candidates.groups().size(), 3u);
  EXPECT_EQ(candidates.size(), 23u + 135u + static_cast<std::size_t>(leftover().readings()));
  EXPECT_EQ(candidates[1].id(), "collimation");
  EXPECT_TRUE(candidates[22].isEffect());
  EXPECT_TRUE(candidates[23].isJump());
  EXPECT_TRUE(candidates[23 + 134].isJump());
  for (Eigen::Index i = 0; i < leftover().readings(); ++i)
    EXPECT_EQ(candidates[158 + static_cast<std::size_t>(i)].grossErrorAt(), i);
  EXPECT_EQ(candidates.groupOf(22).logPrior, std::log(0.04));
  EXPECT_EQ(candidates.groupOf(23).logPrior, std::log(1e-3));
  EXPECT_TRUE(candidates.groupOf(157).oneAtMost);
  EXPECT_EQ(candidates.groupOf(158).offered, 4u);
}

TEST(Candidates, HaveMisreadingsWhereThoseWereAdded) {
  EXPECT_TRUE(ofThreeKinds().haveGrossErrors());
  Candidates candidates;
  EXPECT_FALSE(candidates.haveGrossErrors());
  candidates.add(jumpComponents(leftover()), 1e-3);
  EXPECT_FALSE(candidates.haveGrossErrors());
}

TEST(Candidates, FillInTheProductsOfEachInTurn) {
  const Candidates candidates = ofThreeKinds();
  const SharedProducts residual(leftover(), leftover().residual());
  Eigen::Index size = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) size += candidates[i].columns();
  Eigen::VectorXd all(size);
  candidates.fillProducts(residual, all);
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Eigen::VectorXd own = candidates[i].products(residual);
    EXPECT_EQ(all.segment(first, own.size()), own) << i;
    first += own.size();
  }
}

}  // namespace
}  // namespace alidade
