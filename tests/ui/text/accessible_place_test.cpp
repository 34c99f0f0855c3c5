#include "ui/text/accessible_place.h"

#include <gtest/gtest.h>

#include "tests/ui/support.h"

namespace alidade::ui {
namespace {

TEST(AccessiblePlace, NamesPlacesAsPeopleDo) {
  const Session session = paperSession();
  EXPECT_EQ(accessiblePlace(session, {.position = 1, .reading = 3, .field = "vertical"}),
            QStringLiteral("180°, row 4 (point 4), vertical"));
  EXPECT_EQ(accessiblePlace(session, {.position = 0, .reading = {}, .field = "pointing_zero.vertical"}),
            QStringLiteral("0°, pointing zero β0"));
  EXPECT_EQ(accessiblePlace(session, {.position = {}, .reading = {}, .field = "geometry.distance_mm"}),
            QStringLiteral("distance L"));
  EXPECT_EQ(accessiblePlace(session, {}), QString());
}

TEST(AccessiblePlace, NamesWhatIsKnownByTheNumber) {
  Session session = paperSession();
  session.device.known = {{.effect = "plane_tilt", .parameter = "tilt about x", .unit = "deg"},
                          {.effect = "moon\u202Elight"}};
  const auto accessible = [&](const char* field) {
    return accessiblePlace(session, {.field = field}).toStdString();
  };
  EXPECT_EQ(accessible("device.known[0].sigma"), "known size of plane tilt, tilt about x, u");
  EXPECT_EQ(accessible("device.known[1]"), "known size of moon\\u202elight");
  EXPECT_EQ(accessible("device.known[2].sigma"), "device.known[2].sigma") << "it is gone";
}

TEST(AccessiblePlace, TellsAPositionMeasuredAgainFromTheFirst) {
  Session session = paperSession();
  session.positions.push_back(session.positions[0]);
  EXPECT_EQ(accessiblePlace(session, {.position = 2, .reading = 3, .field = "vertical"}),
            QStringLiteral("0° again, row 4 (point 4), vertical"));
  EXPECT_EQ(accessiblePlace(session, {.position = 0, .reading = 3, .field = {}}),
            QStringLiteral("0°, row 4 (point 4)"));
}

TEST(AccessiblePlace, SurvivesPlacesThatAreGone) {
  EXPECT_EQ(accessiblePlace(blankSession(), {.position = 7, .reading = 3, .field = "vertical"}),
            QStringLiteral("vertical"));
}

}  // namespace
}  // namespace alidade::ui
