#include "core/exchange/file_format.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "core/exchange/import.h"
#include "core/exchange/recognise.h"
#include "tests/support/file_content.h"

// One table defines every format: those that are read, and those that are named and refused.

namespace alidade::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const std::string samplesOfImport = ALIDADE_REFERENCE_DIR "/import/";

/// The refusal of an import; empty if the file can be imported.
std::string importRefusalOf(const std::string& name) {
  const std::string bytes = contentOf(samplesOfImport + "named/" + name);
  const auto import = importReadings({ReadingsFile{.name = name, .bytes = bytes}});
  return import ? std::string() : import.problem().what;
}

std::string idOfFormatOf(const std::string& text) {
  const FileFormat* format = formatOfText(text);
  return format ? std::string(format->id) : std::string("table");
}

struct NamedFile {
  const char* file;
  const char* format;
};

class NamedFormats : public ::testing::TestWithParam<NamedFile> {};

TEST_P(NamedFormats, AreRefusedInASentenceThatNamesThem) {
  EXPECT_THAT(importRefusalOf(GetParam().file),
              StartsWith("is a file of the format " + std::string(GetParam().format)));
  EXPECT_THAT(importRefusalOf(GetParam().file), HasSubstr(": "));
}

INSTANTIATE_TEST_SUITE_P(
    All, NamedFormats,
    ::testing::Values(
        NamedFile{"nikon.raw", "Nikon RAW,"}, NamedFile{"nikon-without-heading.raw", "Nikon RAW,"},
        NamedFile{"survce.rw5", "Carlson RW5 / TDS RAW,"},
        NamedFile{"comments-first.rw5", "Carlson RW5 / TDS"}, NamedFile{"gts6.txt", "Topcon GTS-6,"},
        NamedFile{"gts7.gt7", "Topcon GTS-7 / South"}, NamedFile{"south.raw", "Topcon GTS-7 / South"},
        NamedFile{"geodimeter.are", "Geodimeter"}, NamedFile{"geodimeter-rows.are", "Geodimeter"},
        NamedFile{"elta.rec", "Zeiss REC500,"}, NamedFile{"survey-controller.dc", "Trimble DC,"},
        NamedFile{"office.idx", "Leica IDEX,"}, NamedFile{"receiver.obs", "RINEX"},
        NamedFile{"foif.txt", "FOIF,"}, NamedFile{"kern.txt", "Kern,"}, NamedFile{"plan.dxf", "DXF"},
        NamedFile{"plan.dwg", "DWG"}, NamedFile{"table.rtf", "RTF,"}, NamedFile{"page.html", "HTML,"},
        NamedFile{"track.gpx", "XML,"}, NamedFile{"report.pdf", "PDF,"}, NamedFile{"table.xlsx", "Excel"},
        NamedFile{"table.ods", "OpenDocument"}, NamedFile{"arc.zip", "ZIP archive:"},
        NamedFile{"table.xls", "Excel"}, NamedFile{"png.bin", "PNG"}, NamedFile{"jpg.bin", "PNG, JPEG"},
        NamedFile{"job.sqlite", "SQLite"}, NamedFile{"points.crd", "Carlson CRD"},
        NamedFile{"job.dbx", "Leica DBX,"}),
    [](const auto& tested) {
      std::string name = tested.param.file;
      std::ranges::replace_if(
          name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
      return name;
    });

TEST(NamedFormatsOfText, KeepTheSentenceOfSessions) {
  EXPECT_THAT(importRefusalOf("rows.json"), StartsWith("is JSON, not a file of readings"));
}

TEST(FileFormats, TakeNoSampleForAnotherFormat) {
  std::size_t tables = 0;
  for (const char* folder :
       {ALIDADE_SAMPLES_DIR, ALIDADE_REFERENCE_DIR, ALIDADE_REFERENCE_DIR "/../fuzz/corpus/csv",
        ALIDADE_REFERENCE_DIR "/import/read"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string suffix = entry.path().extension().string();
      const bool isTable =
          suffix == ".csv" || (suffix.empty() && entry.path().parent_path().filename() == "csv");
      if (!entry.is_regular_file() || (!isTable && suffix != ".gsi" && suffix != ".jxl")) continue;
      const auto text = readingsText(contentOf(entry.path().string()));
      if (!text) continue;  // a binary file, reported as such
      tables += isTable ? 1 : 0;
      const std::string wanted = isTable ? "table" : suffix == ".gsi" ? "gsi" : "jobxml";
      EXPECT_EQ(idOfFormatOf(*text), wanted) << entry.path();
    }
  EXPECT_GE(tables, 5u);
}

TEST(FileFormats, LeaveTablesThatResembleThemTables) {
  for (const char* table :
       {"CO;Hz;V\nCO;1;2\n", "ST,10.5,20.5\nSS,11.5,21.5\n", "F1,1,0.0,2.4,107.12,88.47,09:31:00\n",
        "LS,HI,Hz,V\n1,2,3,4\n", "10NM  107.1225  98.4730\n", "00NMA 107.1225 98.4730 12\n",
        "   0001   107.1225  98.4730\n   0002   108.1225  98.4730\n", "FOIF OTS652\nPt;Hz;V\n1;10.5;90.5\n",
        "Kern;Hz;V\n1;10.5;90.5\n", "HEADER\nPROJECT A\nPt;Hz;V\n1;10.5;90.5\n", "<5;Hz;V\n1;2;3\n",
        "<Hz>;<V>\n10.5;90.5\n", "[gon];[gon]\n10.5;90.5\n", "0;1\nSECTION;2\n", "BM1;10.5;90.5\n",
        "SD 107,1225 88,4731\nHV 108,1225 88,4731\n", "PK;10.5;90.5\nPK2;11.5;91.5\n",
        "point;Hz;V\n1;2;3\n21.102+17920860;1;2\n"})
    EXPECT_EQ(idOfFormatOf(table), "table") << table;
}

TEST(FileFormats, AreKnownInTheirVariants) {
  EXPECT_EQ(idOfFormatOf("co,nikon raw data format V2.00\nCO,A\n"), "nikon-raw");
  EXPECT_EQ(idOfFormatOf("50 =ARC7\n5 =1\n7 =107.1223\n"), "geodimeter");
  EXPECT_EQ(idOfFormatOf("00NMDC10 V7.50\n10NMARC7\n"), "trimble-dc");
  EXPECT_EQ(idOfFormatOf("For E |Adr 0001|PI 1|\n"), "zeiss-rec");
  EXPECT_EQ(idOfFormatOf("CRD\n1 100.0 200.0\n"), "crd-text");
}

TEST(FileFormats, AreFoundBelowATitle) {
  const std::string gsi = "110001+00000001 21.324+34152240 22.324+08816490\n";
  EXPECT_EQ(idOfFormatOf("Job ARC7, exported 5 March\n" + gsi), "gsi");
  EXPECT_EQ(idOfFormatOf("# remark\n\n" + gsi), "gsi");
  EXPECT_EQ(idOfFormatOf("title\nFor M5|Adr 00001|TI  START |\n"), "m5");
}

TEST(FileFormats, SayAllThatOthersNeed) {
  std::set<std::string_view> ids;
  for (const FileFormat& format : fileFormats()) {
    EXPECT_TRUE(ids.insert(format.id).second) << format.id;
    EXPECT_THAT(std::string(format.name), Not(IsEmpty()));
    EXPECT_EQ(format.read != nullptr, format.reason != nullptr) << format.id;
    EXPECT_EQ(format.read != nullptr, !format.kinds.empty()) << format.id;
    EXPECT_EQ(format.read == nullptr, format.refusal != nullptr) << format.id;
    for (const std::string_view suffix : format.suffixes)
      EXPECT_EQ(isImportedSuffix(suffix), !format.mayHoldSession) << suffix;
  }
  EXPECT_THAT(readingsSuffixes(), Contains("jxl"));
  EXPECT_THAT(readingsSuffixes(), Not(Contains("rw5")));
  EXPECT_TRUE(isImportedSuffix("GSI"));
  EXPECT_TRUE(isImportedSuffix("csv"));
  EXPECT_FALSE(isImportedSuffix("alidade"));
  EXPECT_THAT(readableKinds(), HasSubstr("Leica GSI-8 and GSI-16, "));
}

TEST(FileFormats, ChosenColumnsHoldForWhatOnlyLooksLikeAFormat) {
  TableLayout layout;
  layout.headRows = 1;
  layout.columns = {"point", "horizontal", "vertical"};
  layout.separator = ' ';
  layout.unit = AngleUnit::Gon;
  const std::string bytes = "FOIF 1 2\n1 107.1223 88.4731\n";
  EXPECT_TRUE(importReadings({ReadingsFile{.name = "a.txt", .bytes = bytes, .table = layout}}));
}

/// Guide, README and desktop metadata name every format that is read.
TEST(FileFormats, AreNamedWhereverFormatsAreListed) {
  const std::string root = ALIDADE_SAMPLES_DIR "/../";
  for (const char* file : {"README.md", "core/exchange/README.md", "resources/help/en/entering.html",
                           "resources/help/zh_CN/entering.html", "packaging/desktop/metainfo.xml.in"}) {
    const std::string text = contentOf(root + file);
    for (const std::string_view name : readableFormats())
      EXPECT_THAT(text, HasSubstr(std::string(name))) << file;
  }
  for (const char* file : {"resources/help/en/files.html", "resources/help/zh_CN/files.html"}) {
    const std::string text = contentOf(root + file);
    for (const std::string_view suffix : readingsSuffixes())
      EXPECT_THAT(text, HasSubstr("<code>." + std::string(suffix) + "</code>")) << file;
  }
  std::string decisions = contentOf(root + "core/exchange/README.md");
  std::ranges::replace(decisions, '\n', ' ');  // a name may be wrapped
  for (const FileFormat& format : fileFormats()) {
    if (!format.read) {
      EXPECT_THAT(decisions, HasSubstr(std::string(format.name)));
    }
  }
}

}  // namespace
}  // namespace alidade::test
