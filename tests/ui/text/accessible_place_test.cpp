#include "ui/text/accessible_place.h"

#include <gtest/gtest.h>

#include <QRegularExpression>

#include "core/session/row_fields.h"
#include "tests/ui/language/speaking.h"
#include "tests/ui/support.h"
#include "ui/document/field.h"

namespace alidade::ui {
namespace {

TEST(AccessiblePlace, NamesPlacesAsPeopleDo) {
  const Session session = paperSession();
  EXPECT_EQ(accessiblePlace(session, {.position = 1, .reading = 3, .field = "vertical"}),
            QStringLiteral("180°, row 4 (point 4), vertical reading"));
  EXPECT_EQ(accessiblePlace(session, {.position = 0, .reading = {}, .field = "pointing_zero.vertical"}),
            QStringLiteral("0°, pointing zero β0"));
  EXPECT_EQ(accessiblePlace(session, {.position = {}, .reading = {}, .field = "geometry.distance_mm"}),
            QStringLiteral("distance L"));
  EXPECT_EQ(accessiblePlace(session, {}), QString());
}

TEST(AccessiblePlace, NamesEveryFieldInTheLanguageOfTheWindow) {
  const Speaking speaking{QStringLiteral("zh_CN")};
  const Session session = paperSession();
  static const QRegularExpression english(QStringLiteral("[A-Za-z]{2,}"));
  const auto expectChinese = [&](const Place& place) {
    const QString text = accessiblePlace(session, place);
    EXPECT_FALSE(text.contains(english)) << place.path() << ": " << text.toStdString();
  };
  for (const RowField& field : rowFields)
    expectChinese({.position = 0, .reading = 2, .field = std::string(field.key)});
  for (const Field& field : allFields()) {
    Place place{.field = std::string(field.name)};
    if (field.isOfPosition) place.position = 1;
    expectChinese(place);
  }
  for (const char* field : {"model.effects", "protocol.positions[0].rounds", "own_effects[0].formula",
                            "own_effects[0].parameters[0].unit", "own_effects[1].id"})
    expectChinese({.field = field});
  expectChinese({.position = 0, .field = "readings"});
  EXPECT_EQ(accessiblePlace(session, {.position = 0, .reading = 2, .field = "vertical"}).toStdString(),
            "0°、第 3 行（测点 3）、竖直读数");
  EXPECT_EQ(accessiblePlace(session, {.field = "own_effects[1].formula"}).toStdString(),
            "自定义效应 2 的公式");
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
  EXPECT_EQ(accessible("device.known[2].sigma"), "known value of the device") << "it is gone";
}

TEST(AccessiblePlace, TellsAPositionMeasuredAgainFromTheFirst) {
  Session session = paperSession();
  session.positions.push_back(session.positions[0]);
  EXPECT_EQ(accessiblePlace(session, {.position = 2, .reading = 3, .field = "vertical"}),
            QStringLiteral("0° again, row 4 (point 4), vertical reading"));
  EXPECT_EQ(accessiblePlace(session, {.position = 0, .reading = 3, .field = {}}),
            QStringLiteral("0°, row 4 (point 4)"));
}

TEST(AccessiblePlace, SurvivesPlacesThatAreGone) {
  EXPECT_EQ(accessiblePlace(blankSession(), {.position = 7, .reading = 3, .field = "vertical"}),
            QStringLiteral("vertical reading"));
}

}  // namespace
}  // namespace alidade::ui
