#include "core/exchange/column_name.h"

#include <gmock/gmock.h>

#include "core/exchange/csv_reader.h"
#include "core/exchange/heading_words.h"
#include "core/exchange/table_faces.h"
#include "core/exchange/unread_rows.h"
#include "core/exchange/words.h"

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string keyOf(const std::string& heading) {
  const auto column = columnName(heading).column;
  return column ? column->key() : "";
}

TEST(ColumnName, IsKnownInEachLanguage) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> names{
      {"point",
       {"Point", "Punkt", "PUNKT", "Pkt.-Nr.", "Zielpunkt", "点号", "点", "测点", "照准点", "Punto", "точка",
        "Точка визирования", "№ точки", "point visé", "Target ID", "Nr.", "N°"}},
      {"horizontal",
       {"Hz", "Horizontalwinkel", "HORIZONTALRICHTUNG [gon]", "Richtung", "Hz-Winkel", "水平角", "水平盘读数",
        "水平度盘读数", "ángulo horizontal", "Lectura horizontal", "горизонтальный угол",
        "Горизонтальный круг", "отсчёт по горизонтальному кругу", "Гориз. угол", "angle horizontal",
        "cercle horizontal", "H"}},
      {"vertical",
       {"V", "Vertikalwinkel", "Zenitwinkel", "Zenit-Distanz", "天顶距", "竖直角", "竖盘读数", "垂直角",
        "cenital", "distancia cenital", "зенитное расстояние", "Вертикальный круг", "вертикальный угол",
        "distance zénithale", "zenith distance", "Höhenwinkel", "高度角", "угол наклона"}},
      {"face", {"Face", "Lage", "Kreislage", "盘位", "cara", "круг", "Cercle", "círculo"}},
      {"axis", {"axis_deg", "Achse", "轴位", "Achsstellung"}},
      {"round", {"Satz", "测回", "set", "приём"}},
      {"note", {"Bemerkung", "备注", "Observaciones", "примечание", "Remarque"}},
      {"slider", {"slider", "Schlitten", "滑块", "φ"}},
      {"distance",
       {"S", "SD", "HD", "D", "Strecke", "Distanz", "Schrägstrecke [m]", "斜距(m)", "平距", "дистанция",
        "distancia", "distance", "наклонное расстояние, м", "горизонтальное проложение"}},
      {"station", {"Station", "Standpunkt", "测站", "станция", "estación"}}};
  for (const auto& [key, headings] : names)
    for (const std::string& heading : headings) EXPECT_EQ(keyOf(heading), key) << heading;
}

TEST(ColumnName, LeavesHeightsAndWhatItDoesNotKnow) {
  for (const char* heading :
       {"Höhe", "height", "i", "t", "Zielhöhe", "Instrumentenhöhe", "仪高", "Temperatur", "VD",
        "vertical distance", "Hz [mil]", "Hz Mittel", "X", "coordinate of nothing"})
    EXPECT_EQ(keyOf(heading), "") << heading;
}

TEST(ColumnName, TellsUnitsPartsAndFaces) {
  EXPECT_EQ(columnName("Hz [gon]").unit, AngleUnit::Gon);
  EXPECT_EQ(columnName("V (gr)").unit, AngleUnit::Gon);
  EXPECT_EQ(columnName("Hz [°]").unit, AngleUnit::Degrees);
  EXPECT_EQ(columnName("Hz (° ' \")").unit, AngleUnit::Dms);
  EXPECT_EQ(columnName("水平角(度分秒)").unit, AngleUnit::Dms);
  EXPECT_TRUE(columnName("Hz [Grad]").isGrad);
  EXPECT_EQ(columnName("V I").face, 1);
  EXPECT_EQ(columnName("HzR").face, 2);
  EXPECT_EQ(columnName("盘右竖直角").face, 2);
  EXPECT_EQ(columnName("КП верт.").face, 2);
  EXPECT_EQ(columnName("Hz Lage II").face, 2);
  EXPECT_EQ(keyOf("hz_min"), "horizontal_minutes");
  EXPECT_EQ(keyOf("V\""), "vertical_seconds");
}

TEST(ColumnName, HWeaklyNamesTheHorizontalCircle) {
  const Recording recording = readTable("Pt;Hz;V;H\n1;107 12 23;88 47 31;1.65\n", {});
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_THAT(recording.unused, Contains("the column “H” is not used: 1 value"));
  EXPECT_EQ(readTable("Pt;H;V\n1;107 12 23;88 47 31\n", {}).sightings.at(0).row.horizontal, "107 12 23");
}

TEST(ColumnName, OfTwoForOneFieldIsRefused) {
  EXPECT_THAT(readTable("Pt;Hz;Horizontalwinkel;V\n1;1°;2°;3°\n", {}).problems.at(0).text(),
              HasSubstr("is a second column"));
  EXPECT_THAT(readTable("Nr;Punkt;Hz;V\n7;A;107 12 23;88 47 31\n", {}).sightings.at(0).row.point, "A");
}

TEST(ColumnName, GradIsDecidedByTheNumbers) {
  const auto first = [](const std::string& rows, AngleUnit unit = AngleUnit::Unstated) {
    const Recording recording = readTable("Hz [Grad];V [Grad]\n" + rows, {.unit = unit});
    return recording.problems.empty() ? recording.sightings.at(0).row.horizontal : recording.problems[0].what;
  };
  EXPECT_EQ(first("219.1;94.9\n380.1;94.9\n"), "219.1gon");
  // A zero some degrees off the horizon is as near to 100 as to 90, so the vertical circle proves nothing.
  for (const char* rows : {"219.1;98.2\n", "219.1;88.2\n", "219.1;95\n"})
    EXPECT_THAT(first(rows), HasSubstr("may be degrees or gon")) << rows;
  EXPECT_EQ(first("219.1;95\n", AngleUnit::Gon), "219.1gon");
}

TEST(TableRows, ThatAreNoReadingsAreTold) {
  const Recording recording = readTable(
      "Pt;Hz;V;note\n1;107 12 23;88 47 31;Mittel aus "
      "2\nMittel;1;2;\n平均;1;2;\nсреднее;1;2;\nPt;Hz;V;note\nEnde\n4;;;\n"
      "2;107 12 23;88 47 31;\n",
      {});
  EXPECT_THAT(recording.problems, IsEmpty());
  EXPECT_EQ(recording.sightings.size(), 2U);
  EXPECT_THAT(recording.unused, ElementsAre("rows of means or sums are not used: lines 3, 4, 5",
                                            "rows that name the columns again are skipped: line 6",
                                            "rows without a reading of a circle are not used: lines 7, 8"));
  EXPECT_THAT(readTable("Pt,Hz,V\n1,1°,2°\nsunny, wind 3 m/s, no clouds\n", {}).problems, IsEmpty());
  EXPECT_FALSE(readTable("Pt,Hz,V\n1,1°,2°\n2, x107 12 23, 88°\n", {}).sightings.size() == 1)
      << "is refused by its rules";
  EXPECT_THAT(readTable("Pt;Hz;V\n1;1°;2°\nPt;V;Hz\n2;1°;2°\n", {}).problems.at(0).text(),
              HasSubstr("have other names from here on"));
}

TEST(FaceWords, DependOnTheirCompany) {
  const auto of = [](const std::vector<std::string>& cells, bool isSpanish) {
    const FaceWords words(cells, isSpanish);
    std::string faces;
    for (const std::string& cell : cells) faces += words.of(cell);
    return faces;
  };
  EXPECT_EQ(of({"D", "I"}, true), "12");
  EXPECT_EQ(of({"D", "R"}, false), "12");
  EXPECT_EQ(of({"G", "D"}, false), "12");
  EXPECT_EQ(of({"CG", "CD"}, false), "12");
  EXPECT_EQ(of({"CD", "CI"}, false), "12");
  EXPECT_EQ(of({"I", "II"}, true), "12");
  EXPECT_EQ(of({"D", "I"}, false), "D1") << "which is refused as no face";
  for (const auto& [one, two] :
       {std::pair("FL", "FR"), std::pair("F1", "F2"), std::pair("盘左", "盘右"), std::pair("КЛ", "КП"),
        std::pair("VL", "VR"), std::pair("Lage 1", "Lage II"), std::pair("Pos. I", "Pos. II"),
        std::pair("left", "Right"), std::pair("CL", "CR"), std::pair("正镜", "倒镜")})
    EXPECT_EQ(of({one, two}, false), "12") << one;
}

TEST(FoldedText, LeavesCaseAndAccentsOut) {
  EXPECT_EQ(foldedText("HÖHE"), "hohe");
  EXPECT_EQ(foldedText("Ho\u0308he"), "hohe");
  EXPECT_EQ(foldedText("ПРИЁМ"), "прием");
  EXPECT_EQ(foldedText("Ｈｚ"), "hz");
  EXPECT_EQ(foldedText("Straße №"), "strasse no");
}

}  // namespace
}  // namespace alidade::test
