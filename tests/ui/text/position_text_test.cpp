#include "ui/text/position_text.h"

#include <gmock/gmock.h>

namespace alidade::ui {
namespace {

using testing::ElementsAre;

std::vector<std::string> namesOf(const std::vector<std::string>& axes) {
  Session session;
  for (const std::string& axis : axes) session.positions.emplace_back().axisDeg = axis;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < axes.size(); ++i) names.push_back(positionText(session, i).toStdString());
  return names;
}

TEST(PositionText, CountsHowOftenAnAxisComes) {
  EXPECT_THAT(namesOf({"0", "180"}), ElementsAre("0°", "180°"));
  EXPECT_THAT(namesOf({"180", "0", "180", "0", "0"}),
              ElementsAre("180°", "0°", "180° again", "0° again", "0° again (3)"));
}

TEST(PositionText, CountsWhatTheAxisMeansNotHowItIsTyped) {
  EXPECT_THAT(namesOf({"0", " 180.0", "-0", "180"}), ElementsAre("0°", "180°", "0° again", "180° again"));
}

TEST(PositionText, LeavesAnAxisAsTypedThatMeansNothing) {
  EXPECT_THAT(namesOf({"90", "", "90", "0"}), ElementsAre("90°", "—°", "90°", "0°"));
}

}  // namespace
}  // namespace alidade::ui
