#include "core/base/angle_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace alidade {
namespace {

using testing::HasSubstr;

double dms(double degrees, double minutes, double seconds) {
  return degrees + minutes / 60 + seconds / 3600;
}

struct Typed {
  const char* text;
  double degrees;
};

class AcceptedAngle : public testing::TestWithParam<Typed> {};

TEST_P(AcceptedAngle, IsRead) {
  const Result<Angle> angle = parseAngle(GetParam().text);
  ASSERT_TRUE(angle) << angle.problem().what;
  EXPECT_NEAR(angle->degrees(), GetParam().degrees, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Signs, AcceptedAngle,
    testing::Values(Typed{"341°52'24\"", dms(341, 52, 24)}, Typed{"341°52′24.5″", dms(341, 52, 24.5)},
                    Typed{"341º52’24,5”", dms(341, 52, 24.5)}, Typed{"341˚52'24''", dms(341, 52, 24)},
                    Typed{"341°52′24′′", dms(341, 52, 24)}, Typed{"341°52'", dms(341, 52, 0)},
                    Typed{"341°", 341}, Typed{"341°52'24", dms(341, 52, 24)},
                    Typed{"341°52", dms(341, 52, 0)}, Typed{" 341 ° 52 ' 24.25 \" ", dms(341, 52, 24.25)},
                    Typed{"341° 52.4'", dms(341, 52.4, 0)}, Typed{"88°05'09\"", dms(88, 5, 9)}));

INSTANTIATE_TEST_SUITE_P(
    Separators, AcceptedAngle,
    testing::Values(Typed{"341 52 24", dms(341, 52, 24)}, Typed{"341-52-24.5", dms(341, 52, 24.5)},
                    Typed{"341:52:24", dms(341, 52, 24)}, Typed{"341/52/24", dms(341, 52, 24)},
                    Typed{"341.52.24", dms(341, 52, 24)}, Typed{"341.52.24,5", dms(341, 52, 24.5)},
                    Typed{"341\t52\u00A024", dms(341, 52, 24)}, Typed{"341 - 52 - 24", dms(341, 52, 24)},
                    Typed{"0  5   9", dms(0, 5, 9)}));

INSTANTIATE_TEST_SUITE_P(NumberPad, AcceptedAngle,
                         testing::Values(Typed{"3415224", dms(341, 52, 24)},
                                         Typed{"3415224.5", dms(341, 52, 24.5)},
                                         Typed{"3415224,5", dms(341, 52, 24.5)},
                                         Typed{"881649", dms(88, 16, 49)}, Typed{"11649", dms(1, 16, 49)},
                                         Typed{"0005959", dms(0, 59, 59)}, Typed{"341", 341}, Typed{"7", 7},
                                         Typed{"0", 0}));

INSTANTIATE_TEST_SUITE_P(Units, AcceptedAngle,
                         testing::Values(Typed{"341.873333°", 341.873333}, Typed{"341,873333 °", 341.873333},
                                         Typed{"341.873333deg", 341.873333},
                                         Typed{"341.873333 DEG", 341.873333},
                                         Typed{"379.859gon", 379.859 * 0.9},
                                         Typed{"379.859 g", 379.859 * 0.9}, Typed{"100Gon", 90}));

INSTANTIATE_TEST_SUITE_P(Negative, AcceptedAngle,
                         testing::Values(Typed{"-0°30'", -0.5}, Typed{"−12 30 00", -12.5},
                                         Typed{"- 12°30'", -12.5}, Typed{"+12°30'", 12.5},
                                         Typed{"-123000", -12.5}, Typed{"-12-30-00", -12.5},
                                         Typed{"−50gon", -45}, Typed{"725°", 725}));

struct Refused {
  const char* text;
  const char* sentence;
};

class RefusedAngle : public testing::TestWithParam<Refused> {};

TEST_P(RefusedAngle, SaysWhyAndWhatToDo) {
  const Result<Angle> angle = parseAngle(GetParam().text);
  ASSERT_FALSE(angle) << angle->degrees();
  EXPECT_THAT(angle.problem().what, HasSubstr(GetParam().sentence));
}

INSTANTIATE_TEST_SUITE_P(
    Ambiguous, RefusedAngle,
    testing::Values(Refused{"341.5224",
                            "“341.5224” may mean decimal degrees or degrees, minutes and seconds: type "
                            "341.5224° or 341 52 24"},
                    Refused{"341,52245", "type 341.52245° or 341 52 24.5"},
                    Refused{"-12.30", "type -12.30° or -12 30 00"},
                    Refused{"341.9", "type 341.9° or put blanks between degrees, minutes and seconds"},
                    Refused{"3415", "“3415” is ambiguous: type 34 15 00 or 34°15'"},
                    Refused{"339 47", "“339 47” is ambiguous: type 339 47 00 or 339°47'"},
                    Refused{"-3415", "type -34 15 00 or -34°15'"}, Refused{"3415.5", "may mean"},
                    Refused{"34152240", "has too many digits"}));

INSTANTIATE_TEST_SUITE_P(
    Impossible, RefusedAngle,
    testing::Values(Refused{"88°71'49\"", "“88°71'49\"” has 71 minutes: minutes go from 0 to 59"},
                    Refused{"88 16 60", "has 60 seconds: seconds stay below 60"},
                    Refused{"886049", "has 60 minutes"}, Refused{"881660.0", "has 60.0 seconds"},
                    Refused{"341.5 30", "only the last part may have decimals"},
                    Refused{"341°52.5'30\"", "only the last part may have decimals"},
                    Refused{"1 2 3 4", "more than three parts"}, Refused{"341-52:24", "mixes separators"},
                    Refused{"52'24\"", "has no degrees"}, Refused{"24\"", "has no degrees"}));

INSTANTIATE_TEST_SUITE_P(
    NoAngle, RefusedAngle,
    testing::Values(Refused{"", "is empty: type an angle such as 341°52'24\""}, Refused{"  \t", "is empty"},
                    Refused{"-", "is not an angle"}, Refused{"east", "“east” is not an angle: type an angle"},
                    Refused{"341 -52 24", "is not an angle"}, Refused{"--5", "is not an angle"},
                    Refused{"341°-52'", "is not an angle"}, Refused{"1e2°", "is not an angle"},
                    Refused{"nan", "is not an angle"}, Refused{"inf°", "is not an angle"},
                    Refused{"341°24\"", "is not an angle"}, Refused{"°", "is not an angle"},
                    Refused{"341°52'24\"x", "is not an angle"}, Refused{".5°", "is not an angle"},
                    Refused{"gon", "is not an angle"}, Refused{"341,,52", "is not an angle"}));

TEST(AngleText, RefusesMoreDigitsThanADoubleHolds) {
  const Result<Angle> angle = parseAngle(std::string(400, '9') + "°");
  ASSERT_FALSE(angle);
  EXPECT_THAT(angle.problem().what, HasSubstr("too large"));
  EXPECT_LT(angle.problem().what.size(), 120u) << "a long text is cut in the sentence";
}

TEST(AngleText, NothingTypedAtRandomCrashesOrGivesAnInfiniteAngle) {
  const std::vector<std::string> pieces = {"0",   "5",   "9", "12",   "60", "341", "°",    "'", "\"", "′",
                                           "″",   "-",   "−", ".",    ",",  ":",   "/",    " ", "g",  "e",
                                           "gon", "deg", "+", "\xFF", "\0", "º",   "\xE2", "''"};
  std::mt19937 random(3);
  std::uniform_int_distribution<std::size_t> piece(0, pieces.size() - 1), length(0, 12);
  std::uniform_int_distribution<int> byte(0, 255);
  int accepted = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string text;
    for (std::size_t n = length(random); n > 0; --n) {
      text += i % 4 ? pieces[piece(random)] : std::string(1, static_cast<char>(byte(random)));
    }
    const Result<Angle> angle = parseAngle(text);
    if (!angle) {
      ASSERT_FALSE(angle.problem().what.empty());
      continue;
    }
    ++accepted;
    ASSERT_TRUE(std::isfinite(angle->radians())) << text;
  }
  EXPECT_GT(accepted, 1000);
}

TEST(AngleText, FormatsWithTwoDigitsOfMinutesAndSeconds) {
  EXPECT_EQ(formatDms(Angle::fromDegrees(dms(341, 2, 4))), "341°02′04″");
  EXPECT_EQ(formatDms(Angle::fromDegrees(dms(0, 0, 5.25)), 2, AngleSigns::Typewriter), "0°00'05.25\"");
}

TEST(AngleText, RoundsSecondsIntoTheNextMinuteAndDegree) {
  EXPECT_EQ(formatDms(Angle::fromDegrees(dms(0, 0, 59.96)), 1), "0°01′00.0″");
  EXPECT_EQ(formatDms(Angle::fromDegrees(dms(359, 59, 59.99)), 0), "360°00′00″");
  EXPECT_EQ(formatDms(Angle::fromDegrees(dms(11, 59, 59.94)), 1), "11°59′59.9″");
}

TEST(AngleText, MarksNegativeAnglesOnceAndNeverZero) {
  EXPECT_EQ(formatDms(Angle::fromDegrees(-0.5)), "−0°30′00″");
  EXPECT_EQ(formatDms(Angle::fromDegrees(-0.5), 0, AngleSigns::Typewriter), "-0°30'00\"");
  EXPECT_EQ(formatDms(Angle::fromArcseconds(-0.04), 1), "0°00′00.0″");
}

TEST(AngleText, FormatsAnglesBeyondAllReadingsWithoutOverflow) {
  EXPECT_EQ(formatDms(Angle::fromDegrees(1e300), 9).substr(0, 3), "1e+");
  EXPECT_THAT(formatDms(Angle::fromRadians(std::nan(""))), HasSubstr("nan"));
}

TEST(AngleText, WhatIsPrintedReadsBackWithinHalfAUnitOfTheLastPlace) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> degrees(-400, 400);
  for (int i = 0; i < 20000; ++i) {
    const Angle angle = Angle::fromDegrees(degrees(random) * (i % 3 ? 1 : 1e-3));
    const int decimals = i % 7;
    const AngleSigns signs = i % 2 ? AngleSigns::Primes : AngleSigns::Typewriter;
    const std::string text = formatDms(angle, decimals, signs);
    const Result<Angle> back = parseAngle(text);
    ASSERT_TRUE(back) << text;
    const double halfUnit = 0.5 * std::pow(10, -decimals);
    const double roundingOfDoubles = 2e-9;  // arcseconds, of 400° in double precision
    ASSERT_LE(std::abs(back->arcseconds() - angle.arcseconds()), halfUnit + roundingOfDoubles) << text;
  }
}

TEST(ParseAngle, ReadsSignsOfKeyboardsAndInputMethods) {
  constexpr double rounding = 1e-12;
  for (const char* text :
       {"107°12´23´´", "107◦12′23″", "107∘12′23″", "107⁰12`23``", "107º12‘23‘‘", "107°12ʹ23ʺ",
        "107度12分23秒", "１０７°１２′２３″", "１０７　１２　２３", "107：12：23", "107°12’23“"}) {
    const Result<Angle> angle = parseAngle(text);
    ASSERT_TRUE(angle) << text << ": " << angle.problem().what;
    EXPECT_NEAR(angle->degrees(), dms(107, 12, 23), rounding) << text;
  }
  EXPECT_NEAR(parseAngle("–0°12′30″")->degrees(), -dms(0, 12, 30), rounding);
  EXPECT_NEAR(parseAngle("１０７，５°")->degrees(), 107.5, rounding);
}

TEST(ParseAngle, RefusesDigitsOfOtherScripts) {
  for (const char* text : {"١٠٧ ١٢ ٢٣", "१०७°", "107°١٢'"})
    EXPECT_THAT(parseAngle(text).problem().what, HasSubstr("has digits of another script")) << text;
}

// Alternative signs have the same meaning.
TEST(ParseAngle, ReadsEachSignAlike) {
  const std::vector<std::vector<std::string>> signs{{"°", "º", "˚", "◦", "∘", "⁰", "度"},
                                                    {"'", "′", "’", "´", "`", "ʹ", "‘", "＇", "分"},
                                                    {"\"", "″", "”", "“", "ʺ", "''", "´´", "＂", "秒"},
                                                    {"-", "−", "–", "－"}};
  std::mt19937 random(11);
  const auto any = [&random](const std::vector<std::string>& all) { return all[random() % all.size()]; };
  for (int i = 0; i < 2000; ++i) {
    const std::string d = std::to_string(random() % 360), m = std::to_string(random() % 60),
                      s = std::to_string(random() % 60) + "." + std::to_string(random() % 10);
    const std::string plain = "-" + d + "°" + m + "'" + s + "\"";
    const std::string typed = any(signs[3]) + d + any(signs[0]) + m + any(signs[1]) + s + any(signs[2]);
    const Result<Angle> angle = parseAngle(typed);
    ASSERT_TRUE(angle) << typed << ": " << angle.problem().what;
    EXPECT_EQ(angle->radians(), parseAngle(plain)->radians()) << typed;
  }
}

}  // namespace
}  // namespace alidade
