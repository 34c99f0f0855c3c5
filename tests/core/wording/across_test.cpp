#include "core/wording/closures.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(AcrossSentence, GivesTheValueWithItsUncertaintyOrSaysThatThereIsNone) {
  MeasuredIntersection measured;
  EXPECT_EQ(acrossSentence(measured),
            "The offset Δz of the arc's centre from the axis, perpendicular to the plane of the arc, was not "
            "measured.");
  measured.across = MeasuredLength{-3.0135, 0.21, 0.415};
  EXPECT_EQ(
      acrossSentence(measured),
      "The arc's centre is Δz = −3.01 mm ± 0.41 mm off the axis, perpendicular to the plane of the arc.");
}

}  // namespace
}  // namespace alidade
