#include "core/exchange/file_format.h"

#include <algorithm>
#include <iterator>

#include "core/base/phrase.h"
#include "core/exchange/field_formats.h"
#include "core/exchange/foreign_files.h"
#include "core/exchange/gsi_reader.h"
#include "core/exchange/gsi_word.h"
#include "core/exchange/jobxml_reader.h"
#include "core/exchange/landxml_reader.h"
#include "core/exchange/m5_reader.h"
#include "core/exchange/recognise.h"
#include "core/exchange/sdr_reader.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"
#include "core/exchange/zeiss_r_reader.h"

namespace alidade {

namespace {

/// Most title lines before the first line written by an instrument.
constexpr std::size_t mostTitleLines = 19;

using IsLine = bool (*)(std::string_view);

/// Does `isFirst` hold for the first non-empty line, or `isBelowTitle` for one of the lines after it?
template <IsLine isFirst, IsLine isBelowTitle>
bool beginsWithLines(std::string_view beginning) {
  const auto lines = contentLines(beginning, mostTitleLines + 1);
  return !lines.empty() && (isFirst(withoutIndent(lines[0])) ||
                            std::any_of(lines.begin() + 1, lines.end(),
                                        [](auto line) { return isBelowTitle(withoutIndent(line)); }));
}

/// Does the line contain a whole GSI word? A number in a table may begin like a GSI word, and a listing may
/// have other text before its words.
bool isSoundGsi(std::string_view line) {
  constexpr int horizontal = 21, vertical = 22;
  const auto block = GsiBlocks({.number = 0, .text = line}).next();
  if (!block || block->words.empty()) return false;
  const auto isCircle = [](const GsiWord& word) {
    return word.isWhole && (word.index == horizontal || word.index == vertical);
  };
  return block->torn.empty() ? block->words.front().isWhole : std::ranges::any_of(block->words, isCircle);
}

bool isFirstOfGsi(std::string_view line) {
  return looksLikeGsi(line) || isSoundGsi(line);
}

/// Does the text begin with the brand as a separate word, and contain no table of readings?
bool beginsWithBrand(std::string_view beginning, std::string_view brand) {
  const auto lines = contentLines(beginning, 1);
  if (lines.empty()) return false;
  const std::string first = upperCase(std::string(withoutIndent(lines[0]).substr(0, brand.size() + 1)));
  return first.starts_with(brand) && (first.size() == brand.size() || first.back() == ' ') &&
         !hasCircles(recogniseTable(beginning).table);
}

constexpr const char* exportReadings = PHRASE_LATER("Phrase",
                                                    "is a file of the format %1, which this program does not "
                                                    "read: export GSI, SDR, JobXML or a table (CSV) instead");
constexpr const char* saveAsCsv = PHRASE_LATER("Phrase",
                                               "is a file of the format %1, which this program does not "
                                               "read: save its table as CSV and choose that file");
constexpr const char* holdsNoReadings =
    PHRASE_LATER("Phrase",
                 "is a file of the format %1, which holds no readings of circles: choose the file of the "
                 "instrument (GSI, SDR, M5, JobXML, LandXML) or a table (CSV)");
constexpr const char* isJson =
    PHRASE_LATER("Phrase", "is JSON, not a file of readings: open it as a session");

/// A format that is recognised and named but cannot be read.
FileFormat namedOnly(std::string_view id, std::string_view name, std::vector<std::string_view> suffixes,
                     bool (*looksLike)(std::string_view), const char* refusal) {
  FileFormat format{.id = id, .name = name, .suffixes = std::move(suffixes), .looksLike = looksLike};
  format.refusal = refusal;
  return format;
}

FileFormat namedBinary(std::string_view id, std::string_view name, std::vector<std::string_view> suffixes,
                       bool (*looksLike)(std::string_view), const char* refusal) {
  FileFormat format = namedOnly(id, name, std::move(suffixes), looksLike, refusal);
  format.isBinary = true;
  return format;
}

FileFormat holdingSession(FileFormat format) {
  format.mayHoldSession = true;
  return format;
}

std::vector<FileFormat> allFormats() {
  return {
      {.id = "gsi",
       .name = "Leica GSI",
       .suffixes = {"gsi"},
       .looksLike = beginsWithLines<isFirstOfGsi, isSoundGsi>,
       .read = readGsi,
       .kinds = "Leica GSI-8 and GSI-16",
       .reason = PHRASE_LATER("Phrase", "its lines are made of words such as 21.102+17920860")},
      {.id = "m5",
       .name = "Trimble M5",
       .suffixes = {"m5", "rec", "dat"},
       .looksLike = beginsWithLines<looksLikeM5, looksLikeM5>,
       .read = readM5,
       .kinds = "Zeiss and Trimble M5",
       .reason = PHRASE_LATER("Phrase", "its lines begin with For M5")},
      {.id = "sdr",
       .name = "Sokkia SDR",
       .suffixes = {"sdr"},
       .looksLike = beginsWithLines<looksLikeSdr, looksLikeSdr>,
       .read = readSdr,
       .kinds = "Sokkia SDR33 and SDR2x",
       .reason = PHRASE_LATER("Phrase", "it begins with the heading of a Sokkia SDR file")},
      {.id = "zeiss-r",
       .name = "Zeiss R4/R5",
       .suffixes = {"r4", "r5"},
       .looksLike = beginsWithLines<looksLikeZeissR, looksLikeZeissR>,
       .read = readZeissR,
       .kinds = "Zeiss R4 and R5",
       .reason = PHRASE_LATER("Phrase", "its lines begin with For R4 or For R5")},
      {.id = "jobxml",
       .name = "Trimble JobXML",
       .suffixes = {"jxl", "xml"},
       .looksLike = looksLikeJobXml,
       .read = readJobXml,
       .kinds = "Trimble JobXML",
       .reason = PHRASE_LATER("Phrase", "its outermost element is JOBFile")},
      {.id = "landxml",
       .name = "LandXML",
       .suffixes = {"xml"},
       .looksLike = looksLikeLandXml,
       .read = readLandXml,
       .kinds = "LandXML (HeXML)",
       .reason = PHRASE_LATER("Phrase", "its outermost element is LandXML")},

      namedOnly("nikon-raw", "Nikon RAW", {"raw", "nik"}, looksLikeNikonRaw, exportReadings),
      namedOnly("rw5", "Carlson RW5 / TDS RAW", {"rw5"}, looksLikeRw5, exportReadings),
      namedOnly("gts-6", "Topcon GTS-6", {"gt6", "gts"}, looksLikeGts6, exportReadings),
      namedOnly("gts-7", "Topcon GTS-7 / South / FOIF RAW", {"gt7"}, looksLikeGts7, exportReadings),
      namedOnly("geodimeter", "Geodimeter (ARE, JOB)", {"are", "job", "obs"}, looksLikeGeodimeter,
                exportReadings),
      namedOnly("rec500", "Zeiss REC500", {}, looksLikeRec500, exportReadings),
      namedOnly("zeiss-rec", "Zeiss Rec (For …)", {}, looksLikeOtherZeiss, exportReadings),
      namedOnly("trimble-dc", "Trimble DC", {"dc"}, looksLikeTrimbleDc, exportReadings),
      namedOnly("idex", "Leica IDEX", {"idx"}, looksLikeIdex, exportReadings),
      namedOnly("gnss", "RINEX / NMEA (GNSS)", {"obs", "nmea"}, looksLikeGnss, holdsNoReadings),
      namedOnly(
          "foif", "FOIF", {}, [](std::string_view text) { return beginsWithBrand(text, "FOIF"); },
          exportReadings),
      namedOnly(
          "kern", "Kern", {}, [](std::string_view text) { return beginsWithBrand(text, "KERN"); },
          exportReadings),
      namedOnly(
          "crd-text", "CRD", {}, [](std::string_view text) { return beginsWithBrand(text, "CRD"); },
          exportReadings),
      namedOnly("dxf", "DXF (CAD)", {"dxf"}, looksLikeDxf, holdsNoReadings),
      namedOnly("rtf", "RTF", {"rtf"}, looksLikeRtf, saveAsCsv),
      namedOnly("html", "HTML", {"html", "htm"}, looksLikeHtml, saveAsCsv),
      namedOnly("postscript", "PostScript", {"ps"}, looksLikePostScript, saveAsCsv),
      namedOnly("xml", "XML", {}, looksLikeOtherXml, exportReadings),
      holdingSession(namedOnly("json", "JSON", {"json"}, looksLikeJson, isJson)),

      holdingSession(namedBinary("pdf", "PDF", {"pdf"}, looksLikePdf, saveAsCsv)),
      namedBinary("xlsx", "Excel, Word (XLSX, DOCX)", {"xlsx", "docx"}, looksLikeExcel, saveAsCsv),
      namedBinary("ods", "OpenDocument (ODS, ODT)", {"ods", "odt"}, looksLikeOpenDocument, saveAsCsv),
      namedBinary("zip", "ZIP archive", {"zip", "gz", "7z", "rar"}, looksLikeArchive,
                  PHRASE_LATER("Phrase", "is a file of the format %1: unpack it and choose the file in it")),
      namedBinary("xls", "Excel, Word (XLS, DOC)", {"xls", "doc"}, looksLikeOldOffice, saveAsCsv),
      namedBinary("database", "SQLite, Access (database)", {"sqlite", "mdb"}, looksLikeDatabase,
                  exportReadings),
      namedBinary("image", "PNG, JPEG, TIFF (image)", {"png", "jpg", "jpeg", "tif", "tiff"}, looksLikeImage,
                  holdsNoReadings),
      namedBinary("dwg", "DWG (CAD)", {"dwg"}, looksLikeDrawing, holdsNoReadings),
      namedBinary("crd", "Carlson CRD", {"crd"}, looksLikeCarlsonCrd, holdsNoReadings),
      namedBinary("dbx", "Leica DBX", {"dbx", "xcf"}, looksLikeNothing, exportReadings),
  };
}

constexpr std::size_t bytesOfMark = 4096;

bool isSuffixOf(const std::string& suffix, const FileFormat& format) {
  return std::ranges::find(format.suffixes, suffix) != format.suffixes.end();
}

/// The suffix in lower case, without its point; empty if there is none.
std::string fileSuffixOf(std::string_view fileName) {
  const std::size_t dot = fileName.rfind('.');
  return dot == std::string_view::npos ? std::string() : lowerCase(std::string(fileName.substr(dot + 1)));
}

const FileFormat* formatOfBytes(std::string_view bytes, std::string_view fileName) {
  const std::string_view head = bytes.substr(0, std::min(bytes.size(), bytesOfMark));
  const bool isUtf16 = head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF");
  const bool isText = isUtf16 || head.find('\0') == std::string_view::npos;
  const auto formats = fileFormats();
  const auto found = std::ranges::find_if(formats, [&](const FileFormat& format) {
    return format.isBinary &&
           (format.looksLike(head) || (!isText && isSuffixOf(fileSuffixOf(fileName), format)));
  });
  return found == formats.end() ? nullptr : &*found;
}

}  // namespace

std::span<const FileFormat> fileFormats() {
  static const std::vector<FileFormat> formats = allFormats();
  return formats;
}

const FileFormat* formatOfText(std::string_view beginning) {
  const auto formats = fileFormats();
  const auto found = std::ranges::find_if(formats, [beginning](const FileFormat& format) {
    return !format.isBinary && format.looksLike(beginning);
  });
  return found == formats.end() ? nullptr : &*found;
}

Problem notRead(const FileFormat& format) {
  return Problem{Phrase::of(format.refusal, format.name)};
}

Result<std::string> readingsText(std::string_view bytes, std::string_view fileName) {
  if (const FileFormat* format = formatOfBytes(bytes, fileName)) return notRead(*format);
  return utf8Text(bytes);
}

std::string readableKinds() {
  std::string kinds;
  for (const FileFormat& format : fileFormats())
    if (format.read) kinds += std::string(format.kinds) + ", ";
  return kinds + "and tables";
}

std::vector<std::string_view> readableFormats() {
  std::vector<std::string_view> names;
  for (const FileFormat& format : fileFormats())
    if (format.read) names.push_back(format.name);
  return names;
}

std::vector<std::string_view> readingsSuffixes() {
  std::vector<std::string_view> suffixes;
  const auto add = [&suffixes](std::string_view suffix) {
    if (std::ranges::find(suffixes, suffix) == suffixes.end()) suffixes.push_back(suffix);
  };
  for (const FileFormat& format : fileFormats())
    if (format.read) std::ranges::for_each(format.suffixes, add);
  for (const std::string_view suffix : {"csv", "tsv", "txt"}) add(suffix);
  return suffixes;
}

bool isImportedSuffix(std::string_view suffix) {
  const std::string lower = lowerCase(std::string(suffix));
  const auto read = readingsSuffixes();
  return std::ranges::find(read, lower) != read.end() ||
         std::ranges::any_of(fileFormats(), [&lower](const FileFormat& format) {
           return !format.mayHoldSession && isSuffixOf(lower, format);
         });
}

}  // namespace alidade
