#include "core/adjustment/numerics/prior.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(Prior, SaysNothingUnlessTold) {
  const Prior nothing;
  EXPECT_FALSE(nothing.isInformative());
  EXPECT_EQ(nothing.derivative(), 0);
  EXPECT_EQ(nothing.residual(17), 0);
  EXPECT_EQ(nothing.weight(), 0);
}

// The estimate from one reading and a prior is their mean, weighted by 1/σ².
TEST(Prior, CountsAsOneMoreObservation) {
  const Prior known{10, 2};
  const double read = 13, sigma = 1, start = 11;
  const double normal = 1 / (sigma * sigma) + known.derivative() * known.derivative();
  const double right = (read - start) / (sigma * sigma) + known.derivative() * known.residual(start);
  EXPECT_NEAR(start + right / normal, (read / 1 + 10.0 / 4) / (1 + 1.0 / 4), 1e-14);
  EXPECT_TRUE(known.isInformative());
  EXPECT_EQ(known.weight(), 1.0 / 4);
  EXPECT_EQ(known.residual(10), 0);
  EXPECT_EQ(known.residual(14), -2);
}

}  // namespace
}  // namespace alidade
