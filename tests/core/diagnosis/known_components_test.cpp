#include "core/diagnosis/known_components.h"

#include <gtest/gtest.h>

#include "core/diagnosis/inquiry.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

std::size_t momentsOf(const std::string& protocol) {
  const Session session = *simulate(*protocolByName(protocol), drawTruth(5), 5);
  const GapModel model = *modelOf(*examine(session).measurement);
  const Leftover leftover({linearise(model.measurement, model.fit, model.options)});
  return jumpComponents(leftover, {}).size();
}

// Rows alone in their visits: 34 rows have 33 moments between them, less one behind the first and one before
// the last row of each position. A second face or the slider tells a step from a misreading.
TEST(KnownComponents, StepIsNotSoughtWhereItIsAMisreading) {
  EXPECT_EQ(momentsOf("paper"), 33u - 4u);
  EXPECT_EQ(momentsOf("there-and-back"), 67u - 4u);
  EXPECT_EQ(momentsOf("paper-slider"), 33u);
  EXPECT_EQ(momentsOf("two-face"), 135u);
}

// At the ends of the arc, 10° and 170°, the horizontal circle shows nearly all of a slip. A step there would
// leave the very same.
TEST(KnownComponents, SlipInTheLastRowOfAPositionIsNoStep) {
  for (const int axis : {0, 180})
    for (const int point : {1, 17}) {
      SCOPED_TRACE(std::to_string(axis) + "°, point " + std::to_string(point));
      Truth truth = drawTruth(5);
      truth.misreadings = {
          {.axisDeg = axis, .point = point, .horizontal = Angle::fromArcseconds(60), .vertical = {}}};
      const Diagnosis diagnosis =
          *diagnose(*examine(*simulate(*protocolByName("paper"), truth, 5)).measurement);
      ASSERT_EQ(diagnosis.causes.size(), 1u);
      ASSERT_EQ(diagnosis.causes[0].readings.size(), 1u) << diagnosis.causes[0].effect;
      const BlamedReading& blamed = diagnosis.causes[0].readings[0];
      EXPECT_EQ(blamed.axisDeg, axis);
      EXPECT_EQ(blamed.point, point);
      EXPECT_EQ(blamed.kind, ReadingKind::Horizontal);
    }
}

}  // namespace
}  // namespace alidade
