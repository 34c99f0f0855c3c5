#include "ui/report/pdf_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/session/session_file.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/support.h"
#include "ui/report/attached_session.h"

// Checks our file against the rules of ISO 19005-3, quoted by section, with qpdf and poppler. Debian's only
// validator, Apache Preflight, knows only part 1 of the standard: the test ignores only objections that later
// parts lift.

namespace alidade::ui {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string bytesOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  return file.readAll().toStdString();
}

/// The objects of a file, as qpdf lists them.
class Structure {
 public:
  explicit Structure(const Printed& report)
      : m_objects(json::parse(report.tool(QStringLiteral("qpdf"), {QStringLiteral("--json=2"), report.path()})
                                  .toStdString())["qpdf"][1]) {}

  json at(const json& value) const {
    if (!value.is_string() || !value.get<std::string>().ends_with(" R")) return value;
    return dictionary(m_objects.at("obj:" + value.get<std::string>()));
  }
  json trailer() const { return m_objects.at("trailer").at("value"); }
  json catalog() const { return at(trailer().at("/Root")); }
  std::vector<json> ofType(const char* type) const {
    std::vector<json> found;
    for (const auto& [name, object] : m_objects.items())
      if (const json value = dictionary(object); value.is_object() && value.value("/Type", "") == type)
        found.push_back(value);
    return found;
  }
  std::string text() const { return m_objects.dump(); }

 private:
  static json dictionary(const json& object) {
    return object.contains("stream") ? object["stream"]["dict"] : object.value("value", json());
  }

  json m_objects;
};

const Printed& laboratoryReport() {
  static const Printed report = [] {
    Session session = paperSession();
    session.title = "Guideway 7 & <others>";
    session.report.laboratory = "Length Laboratory, Δ & Sons";
    ReportOptions options;
    options.logo = QImage(40, 20, QImage::Format_RGB32);
    options.logo.fill(Qt::darkRed);
    return Printed(session, options);
  }();
  return report;
}

TEST(PdfArchive, IsSoundAndOfTheVersionThatMayHoldFiles) {
  const QString checked =
      laboratoryReport().tool(QStringLiteral("qpdf"), {QStringLiteral("--check"), laboratoryReport().path()});
  EXPECT_TRUE(checked.contains(QStringLiteral("No syntax or stream encoding errors found")));
  EXPECT_TRUE(checked.contains(QStringLiteral("File is not encrypted")));  // 6.1.3
  const std::string bytes = bytesOf(laboratoryReport().path());
  EXPECT_TRUE(bytes.starts_with("%PDF-1.7\n%"));  // 6.1.2
  for (int i = 10; i < 14; ++i)
    EXPECT_GT(static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)]), 127);
  EXPECT_EQ(Structure(laboratoryReport()).trailer().at("/ID").size(), 2u);  // 6.1.3
}

TEST(PdfArchive, EndsEachStreamOnALineOfItsOwn) {
  const std::string bytes = bytesOf(laboratoryReport().path()), mark = "endstream";
  std::size_t streams = 0;
  for (std::size_t at = bytes.find(mark); at != std::string::npos; at = bytes.find(mark, at + 1), ++streams)
    EXPECT_EQ(bytes[at - 1], '\n') << at;  // 6.1.7.1
  EXPECT_GT(streams, 10u);
}

/// Objections without the running numbers of their objects.
std::set<std::string> objectionsOfPreflight(const QString& path) {
  QStringList jars;
  for (const char* jar : {"preflight", "pdfbox2", "xmpbox", "pdfbox2-tools", "commons-logging", "commons-io",
                          "fontbox2", "javax.activation", "jaxb-api"})
    jars.append(QStringLiteral("/usr/share/java/%1.jar").arg(QString::fromLatin1(jar)));
  QProcess java;
  java.setProcessChannelMode(QProcess::MergedChannels);
  java.start(QStringLiteral("java"), {QStringLiteral("-cp"), jars.join(u':'),
                                      QStringLiteral("org.apache.pdfbox.preflight.Validator_A1b"), path});
  if (!java.waitForFinished(60000)) return {"no answer"};
  std::set<std::string> objections;
  for (const QString& line : QString::fromUtf8(java.readAll()).split(u'\n', Qt::SkipEmptyParts)) {
    if (line.contains(QStringLiteral("is not a valid PDF/A-1b file")) ||
        line.contains(QStringLiteral("is a valid PDF/A-1b file")))
      continue;
    static const QRegularExpression font(QStringLiteral("[A-Z]{6}\\+[A-Za-z-]+"));
    objections.insert(QString(line).replace(font, QStringLiteral("FONT")).toStdString());
  }
  return objections;
}

bool hasPreflight() {
  return QFile::exists(QStringLiteral("/usr/share/java/preflight.jar")) &&
         !QStandardPaths::findExecutable(QStringLiteral("java")).isEmpty();
}

TEST(PdfArchive, HasNothingAgainstItInAValidatorButWhatLaterPartsAllow) {
  if (!hasPreflight()) GTEST_SKIP() << "Apache Preflight is not installed";
  const std::set<std::string> ofThePart = {
      "7.11.2 : Error on MetaData, part must be 1",
      "3.1.11 : Invalid Font definition, FONT: The CIDSet entry is missing for the Composite Subset"};
  const std::set<std::string> ofFiles = {
      "1.4.7 : Trailer Syntax error, EmbeddedFile entry is present in the Names dictionary",
      "1.2.9 : Body Syntax error, EmbeddedFile entry is present in a FileSpecification dictionary"};
  ReportOptions options;
  options.hasSession = false;
  EXPECT_EQ(objectionsOfPreflight(Printed(paperSession(), options).path()), ofThePart);
  std::set<std::string> all = ofThePart;
  all.insert(ofFiles.begin(), ofFiles.end());
  EXPECT_EQ(objectionsOfPreflight(laboratoryReport().path()), all);
}

TEST(PdfArchive, DeclaresItselfAndSaysTheSameInBothPlaces) {
  const Printed& report = laboratoryReport();
  const std::string xmp =
      report.tool(QStringLiteral("pdfinfo"), {QStringLiteral("-meta"), report.path()}).toStdString();
  for (const char* text : {"<pdfaid:part>3</pdfaid:part>",
                           "<pdfaid:conformance>B</pdfaid:conformance>",  // 6.6.4
                           "<rdf:li xml:lang=\"x-default\">Acceptance report: Guideway 7 &amp; "
                           "&lt;others&gt;</rdf:li>",  // 6.6.2
                           "<rdf:li>Length Laboratory, Δ &amp; Sons</rdf:li>", "<xmp:CreatorTool>Alidade ",
                           "<xmp:CreateDate>2026-03-14T", "<xmp:ModifyDate>2026-03-14T", "<pdf:Producer>Qt "})
    EXPECT_THAT(xmp, HasSubstr(text));
  const std::string info = report.tool(QStringLiteral("pdfinfo")).toStdString();
  EXPECT_THAT(info, testing::ContainsRegex("Title: +Acceptance report: Guideway 7 & <others>"));
  EXPECT_THAT(info, testing::ContainsRegex("Author: +Length Laboratory, Δ & Sons"));
  const json metadata = Structure(report).at(Structure(report).catalog().at("/Metadata"));
  EXPECT_FALSE(metadata.contains("/Filter"));
}

TEST(PdfArchive, HasOneOutputIntentAndNothingTransparent) {
  const Structure structure(laboratoryReport());
  const json intents = structure.at(structure.catalog().at("/OutputIntents"));
  ASSERT_EQ(intents.size(), 1u);  // 6.2.3
  EXPECT_EQ(structure.at(intents[0]).at("/S"), "/GTS_PDFA1");
  EXPECT_EQ(structure.at(structure.at(intents[0]).at("/DestOutputProfile")).at("/N"), 3);
  ASSERT_FALSE(structure.ofType("/ExtGState").empty());
  for (const json& state : structure.ofType("/ExtGState")) {
    EXPECT_EQ(state.value("/ca", 1.0), 1.0);
    EXPECT_EQ(state.value("/CA", 1.0), 1.0);
    EXPECT_EQ(state.value("/SMask", "/None"), "/None");
  }
  for (const json& image : structure.ofType("/XObject")) {
    EXPECT_FALSE(image.contains("/SMask"));
    EXPECT_NE(image.value("/Interpolate", false), true);  // 6.2.8
  }
  for (const char* forbidden : {"/LZWDecode", "/JavaScript", "/OpenAction", "/AA\"", "/Launch", "/CIDSet"})
    EXPECT_EQ(structure.text().find(forbidden), std::string::npos) << forbidden;
}

TEST(PdfArchive, EmbedsEveryFontUnderTheNameOfItsSubset) {
  const Structure structure(laboratoryReport());
  std::size_t fonts = 0;
  for (const json& font : structure.ofType("/Font")) {
    if (font.value("/Subtype", "") != "/Type0") continue;
    const json descendant = structure.at(structure.at(font.at("/DescendantFonts"))[0]);
    const json descriptor = structure.at(descendant.at("/FontDescriptor"));
    EXPECT_TRUE(descriptor.contains("/FontFile2"));  // 6.2.11.4
    EXPECT_TRUE(font.contains("/ToUnicode"));
    EXPECT_EQ(font.at("/BaseFont"), descriptor.at("/FontName"));
    EXPECT_EQ(descendant.at("/BaseFont"), descriptor.at("/FontName"));
    EXPECT_EQ(descendant.at("/CIDToGIDMap"), "/Identity");  // 6.2.11.3
    ++fonts;
  }
  EXPECT_GE(fonts, 3u) << "text, bold and monospaced";
}

TEST(PdfArchive, HoldsFilesAsTheStandardWantsThem) {
  const Structure structure(laboratoryReport());
  const auto files = structure.ofType("/Filespec");
  ASSERT_EQ(files.size(), 2u);
  std::map<json, json> relationships;
  EXPECT_EQ(structure.at(structure.catalog().at("/AF")).size(), files.size());  // 6.8
  for (const json& file : files) {
    for (const char* key : {"/F", "/UF", "/Desc", "/EF", "/AFRelationship"})
      EXPECT_TRUE(file.contains(key)) << key;
    relationships[file.at("/UF")] = file.at("/AFRelationship");
    const json stream = structure.at(file.at("/EF").at("/F"));
    EXPECT_EQ(stream.at("/Subtype"), "/application/json");
    EXPECT_TRUE(stream.at("/Params").contains("/ModDate"));
  }
  EXPECT_EQ(relationships,
            (std::map<json, json>{{"u:paper-table-1.alidade", "/Source"}, {"u:results.json", "/Data"}}));
}

TEST(PdfArchive, OfTheSameReportHasTheSameBytes) {
  const Session session = paperSession();
  EXPECT_EQ(bytesOf(Printed(session).path()), bytesOf(Printed(session).path()));
  Session other = session;
  other.title = "another";
  EXPECT_NE(bytesOf(Printed(session).path()), bytesOf(Printed(other).path()));
}

TEST(PdfArchive, GivesTheSessionBackToTheByte) {
  ReportSource source = Printed::savedSource();
  source.bytes = QByteArray::fromStdString(writeSession(paperSession())) + "\n  \n";
  const Printed saved(paperSession(), source);
  EXPECT_EQ(*attachedSessionText(bytesOf(saved.path())), source.bytes.toStdString()) << "as in the file";
  Session session = paperSession();
  session.title = "unsaved";
  const Printed unsaved(session, {.fileName = {}, .sha256 = {}, .saved = false, .paths = {}, .bytes = {}});
  EXPECT_EQ(*attachedSessionText(bytesOf(unsaved.path())), writeSession(session));
  ReportOptions options;
  options.hasSession = false;
  const auto none = attachedSessionText(bytesOf(Printed(session, options).path()));
  ASSERT_FALSE(none);
  EXPECT_THAT(none.problem().what, HasSubstr("No session is attached"));
}

TEST(PdfArchive, ReadsTornFilesWithoutHarm) {
  const std::string whole = bytesOf(laboratoryReport().path());
  ASSERT_TRUE(attachedSessionText(whole));
  int refused = 0;
  for (std::size_t cut = 0; cut < whole.size(); cut += whole.size() / 60) {
    const auto read = attachedSessionText(std::string_view(whole).substr(0, cut));
    if (!read) {
      EXPECT_FALSE(read.problem().what.empty());
    }
    refused += !read;
  }
  EXPECT_GT(refused, 50);
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 150) {
    std::string bent = whole;
    bent[at] = static_cast<char>(bent[at] ^ 0x15);
    (void)attachedSessionText(bent);
  }
}

}  // namespace
}  // namespace alidade::ui
