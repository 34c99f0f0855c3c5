#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

#include "core/base/angle_text.h"
#include "core/exchange/angle_parts.h"
#include "core/exchange/csv_reader.h"
#include "core/exchange/joined_table.h"
#include "core/exchange/recognise.h"

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string joinedOf(const std::string& text) {
  const Recording recording = readTable(text, {});
  if (!recording.problems.empty()) return recording.problems.front().text();
  if (recording.sightings.empty()) return "nothing";
  return recording.sightings[0].row.horizontal + " / " + recording.sightings[0].row.vertical;
}

TEST(AngleColumns, AreJoinedHoweverTheyAreNamed) {
  const std::string row = "1;17;41;33;86;12;7\n", wanted = "17 41 33 / 86 12 07";
  for (const char* names :
       {"Pt;Hz_d;Hz_m;Hz_s;V_d;V_m;V_s", "Pt;Hz (°);(');(\");V (°);(');(\")", "Pt;H°;H';H\";V°;V';V\"",
        "Punkt;Hz Grad;Hz Min;Hz Sek;V Grad;V Min;V Sek",
        "点号;水平角度;水平角分;水平角秒;竖直角度;竖直角分;竖直角秒", "Pt;Hz;M;S;V;M;S",
        "Pt;Hd;Hm;Hs;Vd;Vm;Vs", "Pt;Hz;;;V;;", "Pt;Hz;Hz;Hz;V;V;V",
        "Pt;Horizontal;;;Vertical;;\n;deg;min;sec;deg;min;sec", "Pt;Horizontal;;;Vertical;;\n;D;M;S;D;M;S",
        ";;Horizontal;;;Vertical;\nPt;deg;min;sec;deg;min;sec", "Pt;Hz;;;V;;\n;°;';\";°;';\"",
        "punto;ángulo horizontal grados;minutos;segundos;cenital grados;minutos;segundos",
        "точка;горизонтальный угол;;;зенитное расстояние;;\n;град;мин;сек;град;мин;сек",
        "Point;Angle horizontal;;;Distance zénithale;;\n;degrés;minutes;secondes;degrés;minutes;secondes"}) {
    const std::string text = std::string(names) + "\n" + row;
    const auto recognised = recognise(text);
    ASSERT_TRUE(recognised) << names;
    TableLayout layout;
    layout.separator = recognised->table.separator;
    layout.headRows = recognised->table.headRows;
    const Recording byNames = readTable(text, layout), asProposed = readTable(text, recognised->table);
    for (const Recording* recording : {&byNames, &asProposed}) {
      EXPECT_THAT(recording->problems, IsEmpty()) << names;
      ASSERT_EQ(recording->sightings.size(), 1U) << names;
      const Reading& read = recording->sightings[0].row;
      EXPECT_EQ(read.horizontal + " / " + read.vertical, wanted) << names;
    }
  }
}

TEST(AngleColumns, AreProposedWithoutNames) {
  const auto found = recognise("1,17,41,33,86,12,7\n2,118,2,51.5,96,44,30.2\n");
  ASSERT_TRUE(found);
  EXPECT_THAT(found->table.columns,
              ElementsAre("point", "horizontal", "horizontal_minutes", "horizontal_seconds", "vertical",
                          "vertical_minutes", "vertical_seconds"));
  EXPECT_THAT(found->joinable, Contains(JoinableColumns{1, 3}));
  EXPECT_THAT(found->joinable, Contains(JoinableColumns{4, 3}));
}

TEST(AngleColumns, LoseNoPart) {
  EXPECT_THAT(joinedOf("Pt,hz deg,hz min,hz sec,v deg,v min,v sec\n1,17,41,,86,12,7\n"),
              HasSubstr("lacks degrees, minutes or seconds"));
  EXPECT_THAT(joinedOf("Pt,hz sec,v sec\n1,33,7\n"), HasSubstr("holds a part of an angle"));
  EXPECT_THAT(joinedOf("Pt,hz deg,hz sec,v deg,v sec\n1,17,33,86,7\n"),
              HasSubstr("holds a part of an angle"));
  EXPECT_THAT(joinedOf("Pt,Hz,foo,bar,V,x,z\n1,17,41,33,86,12,7\n"), HasSubstr("may hold their minutes"));
  EXPECT_THAT(joinedOf("Pt,hz deg,hz min,hz sec,v deg,v min,v sec\n1,17,61,0,86,12,7\n"),
              HasSubstr("61 minutes"));
  EXPECT_THAT(joinedOf("Pt,hz deg,hz min,hz sec,v deg,v min,v sec\n1,17,41,60.5,86,12,7\n"),
              HasSubstr("60.5 seconds"));
  EXPECT_THAT(joinedOf("Pt,hz deg,hz min,hz sec,v deg,v min,v sec\n1,17.5,41,0,86,12,7\n"),
              HasSubstr("decimals before its last part"));
}

TEST(AngleColumns, OfAnUnreadableRowAreNoHeading) {
  const Recording recording = readTable("target,face,Hz,V\nP,I,107°12'61\",88°47'31\"\n", {});
  EXPECT_EQ(recording.sightings.size(), 1U) << "whose angle is refused where its rules are";
}

TEST(AngleColumns, CarrySixtyAndTellIt) {
  const Recording recording =
      readTable("Pt,hz deg,hz min,hz sec,v deg,v min,v sec\n1,359,59,60,86,60,7\n2,107,12,60,88,47,31\n", {});
  ASSERT_EQ(recording.sightings.size(), 2U);
  EXPECT_EQ(recording.sightings[0].row.horizontal, "0°");
  EXPECT_EQ(recording.sightings[0].row.vertical, "87 00 07");
  EXPECT_EQ(recording.sightings[1].row.horizontal, "107 13 00");
  EXPECT_THAT(recording.unused,
              Contains(HasSubstr("carry to the next degree or minute: 3 in all, the first in line 2")));
  EXPECT_EQ(angleOfFile("107°12'60\"").text, "107 13 00");
  EXPECT_EQ(angleOfFile("-0 59 60").text, "-1 00 00");
  EXPECT_EQ(angleOfFile("400 gon").text, "0gon");
  EXPECT_EQ(angleOfFile("107°12'61\"").text, "107°12'61\"") << "stays, to be refused";
}

TEST(AngleColumns, HaveOneSign) {
  const auto joined = [](const char* d, const char* m, const char* s) {
    const auto angle = joinedAngle({d, m, s}, true, false);
    return angle ? angle->text : angle.problem().what;
  };
  EXPECT_EQ(joined("-0", "12", "30"), "-0 12 30");
  EXPECT_EQ(joined("−0", "12", "30"), "-0 12 30");
  EXPECT_EQ(joined("0", "-12", "30"), "-0 12 30");
  EXPECT_EQ(joined("-3", "-12", "-30"), "-3 12 30");
  EXPECT_THAT(joined("3", "-12", "30"), HasSubstr("has a sign in the middle"));
  EXPECT_NEAR(parseAngle(joined("-0", "12", "30"))->arcseconds(), -750, 1e-9);
  const Recording recording =
      readTable("Pt,Hz deg,Hz min,Hz sec,V deg,V min,V sec\n1,17,41,33,-0,12,30\n", {});
  EXPECT_EQ(recording.verticalCircle, "elevation") << "no zenith circle reads so";
}

TEST(AngleColumns, LoseNoSign) {
  EXPECT_THAT(joinedOf("Pt;Hz d;Hz m;V sign;V d;V m\n1;17;41;-;0;12\n"),
              HasSubstr("“V sign” contains signs"));
  EXPECT_THAT(joinedOf("Pt;Hz d;Hz m;x;V d;V m\n1;17;41;-;0;12\n2;17;41;+;0;12\n"),
              HasSubstr("“x” contains signs"));
  EXPECT_EQ(joinedOf("Pt;Hz d;Hz m;x;V d;V m\n1;17;41;-;0;12\n"), "17 41 / 0 12") << "nothing is known of x";
}

// One cell of another kind keeps unnamed columns from being joined. It must not let the readings lose their
// minutes and seconds.
TEST(AngleColumns, AreRefusedIfOddCellsKeepThemApart) {
  const std::string head = "point;Hz;;;V;;\n", row = "1;341;52;24;88;16;49\n2;342;12;05;88;26;19\n";
  for (const char* odd : {"ZERO;332°32'54\";;;89°59'57\";;\n", "3;343;72;05;88;26;19\n",
                          "3;343;4-;05;88;26;19\n", "3;343;-;-;88;26;09\n", "3;343;12?;05;88;26;19\n"})
    EXPECT_THAT(joinedOf(head + row + odd), HasSubstr("may hold their minutes or seconds")) << odd;
  EXPECT_THAT(joinedOf("point;Hz;;V;\n1;341;52.4;88;16.5\n2;342;62.4;88;16.5\n"),
              HasSubstr("“Hz” holds whole degrees and column 3 may hold their minutes or seconds"));
  EXPECT_EQ(joinedOf(head + row), "341 52 24 / 88 16 49");
}

TEST(AngleColumns, MayHaveTheirSecondsInTheMinutes) {
  EXPECT_EQ(joinedOf("Pt;Hz d;Hz m;Hz s;V d;V m;V s\n1;17;41.5;;86;12;7\n"), "17 41.5 / 86 12 07");
  EXPECT_EQ(joinedOf("Punto;Hz G;Hz M;Hz S;V G;V M;V S\n1;17;41;33;86;12;7\n"), "17 41 33 / 86 12 07");
}

TEST(AngleColumns, MayBeGon) {
  EXPECT_EQ(joinedOf("Pt;Hz g;Hz c;Hz cc;V g;V c;V cc\n1;219;12;34;98;3;5.5\n"), "219.1234gon / 98.03055gon");
}

TEST(AngleColumns, OfBothFacesAreTwoSightings) {
  const Recording recording = readTable(
      "Pt;Hz I d;Hz I m;Hz I s;V I d;V I m;V I s;Hz II d;Hz II m;Hz II s;V II d;V II m;V II s\n"
      "1;17;41;33;86;12;7;197;41;35;273;47;55\n2;18;41;33;86;12;7;;;;;;\n",
      {});
  EXPECT_THAT(recording.problems, IsEmpty());
  ASSERT_EQ(recording.sightings.size(), 3U);
  EXPECT_EQ(recording.sightings[1].row.horizontal, "197 41 35");
  EXPECT_EQ(recording.sightings[1].row.vertical, "273 47 55");
  EXPECT_EQ(recording.sightings[1].row.face, "2");
  EXPECT_EQ(recording.sightings[2].row.face, "1");
}

TEST(AngleColumns, AreJoinedForTheClipboard) {
  const auto table = joinedTable({{"Pt", "Hz", "", "", "V", "", ""},
                                  {"", "deg", "min", "sec", "deg", "min", "sec"},
                                  {"1", "17", "41", "33", "86", "12", "7"}});
  ASSERT_TRUE(table && *table);
  EXPECT_THAT((*table)->rows, ElementsAre(ElementsAre("1", "17 41 33", "86 12 07")));
  const auto refused = joinedTable({{"Pt", "Hz", "a", "V", "b"}, {"1", "17", "41", "86", "12"}});
  ASSERT_TRUE(refused);
  EXPECT_FALSE(*refused);
  EXPECT_FALSE(joinedTable({{"1", "17"}, {"2", "18"}}));
}

/// A circle reading as written in the table, and its arcseconds.
struct WrittenAngle {
  std::array<std::string, 3> parts;
  double arcseconds = 0;
};

WrittenAngle writtenAngle(std::mt19937& random, int mostDegrees) {
  const auto below = [&random](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  const int degrees = below(mostDegrees), minutes = below(60), tenths = below(600);
  const std::string seconds = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  return {{std::to_string(degrees), std::to_string(minutes), seconds},
          3600.0 * degrees + 60.0 * minutes + tenths / 10.0};
}

// Tables of random readings in columns in random order, in each language, are read exactly.
TEST(AngleColumns, AreReadExactlyInAnyOrder) {
  const std::vector<std::array<std::string, 7>> headings{
      {"point", "hz deg", "hz min", "hz sec", "v deg", "v min", "v sec"},
      {"Punkt", "Hz Grad", "Hz Minuten", "Hz Sekunden", "Zenitwinkel Grad", "Zenitwinkel Minuten",
       "Zenitwinkel Sekunden"},
      {"点号", "水平角(度)", "水平角(分)", "水平角(秒)", "天顶距(度)", "天顶距(分)", "天顶距(秒)"},
      {"punto", "ángulo horizontal (grados)", "ángulo horizontal (minutos)", "ángulo horizontal (segundos)",
       "cenital (grados)", "cenital (minutos)", "cenital (segundos)"},
      {"точка", "гор. угол, градусы", "горизонтальный угол, минуты", "горизонтальный угол, секунды",
       "зенитное расстояние, градусы", "зенитное расстояние, минуты", "зенитное расстояние, секунды"},
      {"point", "angle horizontal degrés", "angle horizontal minutes", "angle horizontal secondes",
       "distance zénithale degrés", "distance zénithale minutes", "distance zénithale secondes"}};
  std::mt19937 random(7);
  for (int table = 0; table < 120; ++table) {
    auto names = headings[static_cast<std::size_t>(table) % headings.size()];
    if (names[1].starts_with("гор.")) names[1] = "горизонтальный угол, градусы";
    std::array<std::size_t, 7> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::shuffle(order, random);
    const auto lineOf = [&order](const std::array<std::string, 7>& cells) {
      std::string line;
      for (const std::size_t i : order) line += (line.empty() ? "" : ";") + cells[i];
      return line + "\n";
    };
    std::string text = lineOf(names);
    std::vector<std::pair<double, double>> wanted;
    for (int row = 1; row <= 5; ++row) {
      const WrittenAngle h = writtenAngle(random, 360), v = writtenAngle(random, 180);
      text += lineOf(
          {std::to_string(row), h.parts[0], h.parts[1], h.parts[2], v.parts[0], v.parts[1], v.parts[2]});
      wanted.emplace_back(h.arcseconds, v.arcseconds);
    }
    const Recording recording = readTable(text, {});
    ASSERT_THAT(recording.problems, IsEmpty()) << text << recording.problems.front().text();
    ASSERT_EQ(recording.sightings.size(), wanted.size()) << text;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      constexpr double rounding = 1e-9;  // of doubles of a million arcseconds
      EXPECT_NEAR(parseAngle(recording.sightings[i].row.horizontal)->arcseconds(), wanted[i].first, rounding);
      EXPECT_NEAR(parseAngle(recording.sightings[i].row.vertical)->arcseconds(), wanted[i].second, rounding);
    }
  }
}

}  // namespace
}  // namespace alidade::test
