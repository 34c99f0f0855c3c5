#include "core/exchange/jobxml_reader.h"

#include <map>
#include <pugixml.hpp>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/exchange/field_book.h"
#include "core/exchange/foreign_files.h"
#include "core/exchange/words.h"
#include "core/exchange/xml_file.h"

namespace alidade {

namespace {

/// Goes through the records of the field book.
class JobXmlReader {
 public:
  JobXmlReader(std::string_view text, const std::string& zeroPoint) : m_file(text), m_book(zeroPoint) {}

  Recording read() {
    m_book.recording().verticalCircle = "zenith";
    for (const pugi::xml_node record : xmlChild(m_file.root(), "FieldBook").children()) {
      readRecord(record, m_file.lineOf(record));
      if (m_book.isFull(m_line)) break;
    }
    if (const auto& problem = m_file.problem()) {
      m_book.refuse(problem->line, problem->column, problem->what);
    } else if (m_file.root() && m_book.recording().sightings.empty() && m_book.recording().problems.empty()) {
      m_book.refuse(
          1, 0,
          Phrase::of("the Trimble JobXML file holds no readings of circles in its field book: export "
                     "the job with its observations, or export a table (CSV)"));
    }
    return m_book.finish("JobXML");
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

  /// A point may be set up on again, with another orientation of the circle.
  void readStation(const pugi::xml_node& record) {
    std::string name = xmlText(record, "StationName");
    const int uses = ++m_setUps[name];
    if (uses > 1) name += " (" + std::to_string(uses) + ")";
    m_stations[xmlValue(record, "ID")] = name;
    goTo(name);
  }

  void goTo(const std::string& station) {
    if (station == m_station) return;
    m_station = station;
    m_book.beginStation(station, m_line);
  }

  void readInstrument(const pugi::xml_node& record) {
    std::string name = xmlText(record, "Model");
    if (name.empty()) name = xmlText(record, "Type");
    const std::string serial = xmlText(record, "Serial"), what = Phrase::of("instrument");
    if (!name.empty()) m_book.keep(m_book.recording().instrumentName, name, what, m_line);
    if (!serial.empty()) m_book.keep(m_book.recording().instrumentSerial, serial, what, m_line);
  }

  void readNotes(const pugi::xml_node& record) {
    for (const pugi::xml_node note : xmlChild(record, "Notes").children())
      readNote(trimmed(note.text().get()));
  }

  void readNote(const std::string& note) {
    if (const auto mark = fieldMark(note)) return m_book.take(*mark);
    if (!note.empty()) m_book.setAside(Phrase::of("the note %1", quotation(note)), m_line);
  }

  /// What a record with a circle is where it is no reading; empty where it is one.
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
    if (const std::string kind = otherKind(record); !kind.empty()) return m_book.setAside(kind, m_line);
    const XmlCircles circles{.horizontal = xmlText(circle, "HorizontalCircle"),
                             .vertical = xmlText(circle, "VerticalCircle"),
                             .face = faceOf(xmlText(circle, "Face"))};
    if (circles.horizontal.empty() || circles.vertical.empty())
      return m_book.setAside(Phrase::of("an observation without one of the circles"), m_line);
    RecordedSighting sighting;
    sighting.line = m_line;
    sighting.row.point = xmlText(record, "Name");
    sighting.row.note = xmlText(record, "Code");
    if (const auto problem = enterCircles(circles, sighting)) return m_book.refuse(m_line, 0, *problem);
    takeDistance(xmlText(circle, "EDMDistance"), sighting);
    takeStation(xmlText(record, "StationID"));
    std::string& date = m_book.recording().measuredOn;
    if (date.empty()) date = dateOfTime(xmlValue(record, "TimeStamp"));
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
    m_book.setBeside(Phrase::of("slope distance"), m_line);
  }

  void takeStation(const std::string& id) {
    const auto station = m_stations.find(id);
    if (!id.empty() && station != m_stations.end()) goTo(station->second);
  }

  XmlFile m_file;
  FieldBook m_book;
  std::map<std::string, std::string> m_stations;  ///< their names by the ID of their records
  std::map<std::string, int> m_setUps;            ///< how often each point was set up on
  std::string m_station;
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
