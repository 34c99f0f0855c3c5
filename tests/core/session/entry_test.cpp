#include "core/session/entry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using testing::HasSubstr;

std::string sentence(const char* field, const char* text, const Session& session = blankSession()) {
  return entryProblem(session, field, text).value_or("usable");
}

TEST(Entry, UsableTextsHaveNoProblem) {
  for (const auto& [field, text] : std::initializer_list<std::pair<const char*, const char*>>{
           {"geometry.distance_mm", "2405,5"},
           {"geometry.sigma_distance_mm", "0"},
           {"instrument.sigma_zero_arcsec", ""},
           {"acceptance.coverage", "0.5"},
           {"acceptance.reference_intersection_mm", "-2"},
           {"environment.temperature_c", "-12"},
           {"pointing_zero.vertical", "89 59 57"},
           {"readings.horizontal", "359°59'59.9\""},
           {"readings.slider", ""},
           {"readings.slider", "-360°"},
           {"readings.point", "0"},
           {"readings.round", ""},
           {"readings.face", "2"},
           {"axis_deg", "180"},
           {"geometry.vertical_circle", "elevation"},
           {"model.vertical_angle", ""},
           {"model.radius", ""},
           {"model.radius", "common"},
           {"geometry.sigma_radius_mm", "0"},
           {"instrument.known.value", ""},
           {"instrument.known.sigma", "0.5"},
           {"device.known.value", "-3"},
           {"device.known.from", "anything"},
           {"measured_on", ""},
           {"measured_on", "2020-02-29"},
           {"title", "anything at all"}}) {
    EXPECT_EQ(sentence(field, text), "usable") << field << " = " << text;
  }
}

TEST(Entry, UnusableTextsAreExplained) {
  EXPECT_THAT(sentence("geometry.distance_mm", ""), HasSubstr("is empty: type the distance"));
  EXPECT_THAT(sentence("geometry.distance_mm", "0"), HasSubstr("“0” is out of range: it must be above 0"));
  EXPECT_THAT(sentence("geometry.radius_mm", "1e6"), HasSubstr("out of range"));
  EXPECT_THAT(sentence("geometry.radius_mm", "400 mm"), HasSubstr("leave out “mm”"));
  for (const char* sigma : {"0", "0.0009"})
    EXPECT_THAT(sentence("instrument.sigma_horizontal_arcsec", sigma), HasSubstr("must be at least 0.001"));
  EXPECT_THAT(sentence("environment.temperature_c", "-300"),
              HasSubstr("must be at least -273.15 and below 1000 °C"));
  EXPECT_THAT(sentence("acceptance.coverage", "1"), HasSubstr("must be between 0 and 1"));
  EXPECT_THAT(sentence("readings.horizontal", ""), HasSubstr("is empty: type an angle"));
  EXPECT_THAT(sentence("readings.horizontal", "360"), HasSubstr("lies outside 0°…360°"));
  EXPECT_THAT(sentence("device.known.value", "1e6"), HasSubstr("must be below 1000000 in size"));
  EXPECT_THAT(sentence("instrument.known.sigma", "-1"), HasSubstr("“-1” is out of range"));
  EXPECT_THAT(sentence("instrument.known.sigma", ""), HasSubstr("type the standard uncertainty"));
  EXPECT_THAT(sentence("readings.face", "3"), HasSubstr("“3” is no face: type 1 or 2"));
  EXPECT_THAT(sentence("readings.round", "0"), HasSubstr("rounds are numbered from 1"));
  EXPECT_THAT(sentence("readings.point", "-1"), HasSubstr("points are numbered from 0"));
  EXPECT_THAT(sentence("readings.point", "A"), HasSubstr("is not a whole number"));
  EXPECT_THAT(sentence("axis_deg", ""), HasSubstr("is empty: type the rotation of the axis, 0 or 180"));
  EXPECT_THAT(sentence("geometry.vertical_circle", "Zenith"), HasSubstr("choose zenith or elevation"));
  EXPECT_THAT(sentence("model.vertical_angle", "x"), HasSubstr("choose exact or planar"));
  EXPECT_THAT(sentence("model.radius", "fixed"), HasSubstr("choose free, common or known"));
  EXPECT_THAT(sentence("geometry.sigma_radius_mm", "-1"), HasSubstr("must be 0 or more"));
}

TEST(Entry, DatesMustExist) {
  for (const char* text : {"2019-02-29", "2018-13-01", "2018-1-1", "01.02.2018", "2018-01-01T10:00",
                           "2018-00-10", "20a8-01-01"}) {
    EXPECT_THAT(sentence("measured_on", text), HasSubstr("is no date: type year-month-day")) << text;
  }
}

TEST(Entry, RangeOfTheVerticalCircleFollowsItsKind) {
  Session session = blankSession();
  session.geometry.verticalCircle = "elevation";
  EXPECT_EQ(sentence("readings.vertical", "-5 30 00", session), "usable");
  EXPECT_THAT(sentence("readings.vertical", "-91°", session), HasSubstr("lies outside −90°…360°"));
  session.geometry.verticalCircle = "zenith";
  EXPECT_THAT(sentence("readings.vertical", "-5 30 00", session), HasSubstr("lies outside 0°…360°"));
}

}  // namespace
}  // namespace alidade
