#include "core/exchange/jobxml_reader.h"

#include <pugixml.hpp>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/exchange/foreign_files.h"
#include "core/exchange/words.h"
#include "core/exchange/xml_book.h"

namespace alidade {

namespace {

/// Reads the records of the field book.
class JobXmlReader {
 public:
  JobXmlReader(std::string_view text, const std::string& zeroPoint) : m_book(text, zeroPoint) {}

  Recording read() {
    m_book.recording().verticalCircle = "zenith";
    for (const pugi::xml_node record : xmlChild(m_book.file().root(), "FieldBook").children()) {
      readRecord(record, m_book.file().lineOf(record));
      if (m_book.isFull(m_line)) break;
    }
    return m_book.finish(
        "JobXML", Phrase::of("the Trimble JobXML file holds no readings of circles in its field book: export "
                             "the job with its observations, or export a table (CSV)"));
  }

 private:
  void readRecord(const pugi::xml_node& record, std::size_t line) {
    m_line = line;
    const std::string_view kind = xmlName(record);
    if (kind == "PointRecord") return readPoint(record);
    if (kind == "StationRecord") return readStation(record);
    if (kind == "InstrumentRecord") return readInstrument(record);
    if (kind == "NoteRecord") return readNotes(record);
  }

  void readStation(const pugi::xml_node& record) {
    const std::string id = xmlValue(record, "ID");
    m_book.addSetUp(id, xmlText(record, "StationName"));
    m_book.goTo(id, m_line);
  }

  void readInstrument(const pugi::xml_node& record) {
    std::string name = xmlText(record, "Model");
    if (name.empty()) name = xmlText(record, "Type");
    m_book.takeInstrument(name, xmlText(record, "Serial"), m_line);
  }

  void readNotes(const pugi::xml_node& record) {
    for (const pugi::xml_node note : xmlChild(record, "Notes").children())
      m_book.takeNote(trimmed(note.text().get()), m_line);
  }

  /// The kind of a record with a circle that is not a reading; empty for a reading.
  static std::string otherKind(const pugi::xml_node& record) {
    if (xmlText(record, "Deleted") == "true") return Phrase::of("a deleted observation");
    const std::string method = xmlText(record, "Method");
    if (method.empty() || isOneOf(method, {"DirectReading", "AverageMeasurements", "AngleOnly"})) return {};
    if (method == "MeanTurnedAngle") return Phrase::of("a mean of observations (MeanTurnedAngle)");
    return Phrase::of("an observation that is no direct reading (%1)", quotation(method));
  }

  void readPoint(const pugi::xml_node& record) {
    const pugi::xml_node circle = xmlChild(record, "Circle");
    if (!circle) return m_book.setAside(Phrase::of("a point without readings of circles"), m_line);
    if (const std::string kind = otherKind(record); !kind.empty())
      return m_book.setAsideSighting(kind, m_line);
    const XmlCircles circles{.horizontal = xmlText(circle, "HorizontalCircle"),
                             .vertical = xmlText(circle, "VerticalCircle"),
                             .face = faceOf(xmlText(circle, "Face"))};
    if (circles.horizontal.empty() || circles.vertical.empty())
      return m_book.setAsideSighting(Phrase::of("an observation without one of the circles"), m_line);
    RecordedSighting sighting;
    sighting.line = m_line;
    sighting.row.point = xmlText(record, "Name");
    sighting.row.note = xmlText(record, "Code");
    if (const auto problem = enterCircles(circles, sighting)) return m_book.refuse(m_line, 0, *problem);
    takeDistance(xmlText(circle, "EDMDistance"), sighting);
    if (const std::string id = xmlText(record, "StationID"); !id.empty()) m_book.goTo(id, m_line);
    m_book.takeTime(xmlValue(record, "TimeStamp"));
    m_book.add(std::move(sighting));
  }

  static std::string faceOf(const std::string& face) {
    if (face == "Face1") return "1";
    return face == "Face2" ? "2" : std::string();
  }

  void takeDistance(const std::string& metres, RecordedSighting& sighting) {
    const Result<double> distance = parseNumber(metres);
    if (!distance || !(*distance > 0)) return;
    sighting.distanceM = *distance;
    m_book.setAsideForCheck(Phrase::of("slope distance"), m_line);
  }

  XmlBook m_book;
  std::size_t m_line = 1;
};

}  // namespace

bool looksLikeJobXml(std::string_view beginning) {
  return xmlRootName(beginning) == "JOBFile";
}

Recording readJobXml(std::string_view text, const std::string& zeroPoint) {
  return JobXmlReader(text, zeroPoint).read();
}

}  // namespace alidade
