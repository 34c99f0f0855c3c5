#include "core/exchange/landxml_reader.h"

#include <map>
#include <numbers>
#include <optional>
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

std::optional<AngleUnit> landXmlUnit(const std::string& name) {
  const std::string unit = lowerCase(name);
  if (unit.empty() || unit == "radians") return AngleUnit::Radians;
  if (unit == "grads") return AngleUnit::Gon;
  if (unit == "decimal degrees") return AngleUnit::Degrees;
  if (unit == "decimal dd.mm.ss") return AngleUnit::Dms;
  return std::nullopt;
}

/// Metres per unit of length of the schema; 0 for other names.
double metresOf(const std::string& name) {
  static const std::map<std::string, double> units{{"", 1},
                                                   {"meter", 1},
                                                   {"millimeter", 1e-3},
                                                   {"centimeter", 1e-2},
                                                   {"kilometer", 1e3},
                                                   {"foot", 0.3048},
                                                   {"ussurveyfoot", 1200.0 / 3937},
                                                   {"inch", 0.0254},
                                                   {"mile", 1609.344}};
  const auto unit = units.find(lowerCase(name));
  return unit == units.end() ? 0 : unit->second;
}

/// Reads the surveys of a file.
class LandXmlReader {
 public:
  LandXmlReader(std::string_view text, const std::string& zeroPoint) : m_book(text, zeroPoint) {}

  Recording read() {
    m_book.recording().verticalCircle = "zenith";
    const pugi::xml_node root = m_book.file().root();
    if (takeUnits(xmlChild(root, "Units"))) {
      takePoints(xmlChild(root, "CgPoints"));
      for (const pugi::xml_node survey : root.children())
        if (xmlName(survey) == "Survey") readSurvey(survey);
    }
    return m_book.finish(
        "LandXML", Phrase::of("the LandXML file holds no raw observations with both circles: export the "
                              "observations as they were read (RawObservation), or GSI or a table (CSV)"));
  }

 private:
  bool takeUnits(const pugi::xml_node& units) {
    const pugi::xml_node system = units.first_child();
    const std::string angular = xmlValue(system, "angularUnit");
    const auto unit = landXmlUnit(angular);
    m_hasUnit = !angular.empty();
    m_metres = metresOf(xmlValue(system, "linearUnit"));
    if (unit) {
      m_unit = *unit;
      return true;
    }
    m_book.refuse(m_book.file().lineOf(system ? system : m_book.file().root()), 0,
                  Phrase::of("%1 is no unit of angles of LandXML (radians, grads, decimal degrees, decimal "
                             "dd.mm.ss): export the file in one of them",
                             quotation(angular)));
    return false;
  }

  /// Collects the oIDs of points by the names with which observations refer to them.
  void takePoints(const pugi::xml_node& points) {
    for (const pugi::xml_node point : points.children()) {
      const std::string name = xmlValue(point, "name"), id = xmlValue(point, "oID");
      if (!name.empty() && !id.empty()) m_points.emplace(name, id);
    }
  }

  void readSurvey(const pugi::xml_node& survey) {
    takePoints(xmlChild(survey, "CgPoints"));
    readInstrument(xmlChild(xmlChild(survey, "Equipment"), "InstrumentDetails"));
    for (const pugi::xml_node setUp : survey.children())
      if (xmlName(setUp) == "InstrumentSetup")
        m_book.addSetUp(xmlValue(setUp, "id"), xmlValue(setUp, "stationName"));
    for (const pugi::xml_node part : survey.children()) {
      if (xmlName(part) == "InstrumentSetup") readObservations(part, xmlValue(part, "id"));
      if (xmlName(part) == "ObservationGroup") readObservations(part, xmlValue(part, "setupID"));
      if (xmlName(part) == "FieldNote") readNote(part);
    }
  }

  void readInstrument(const pugi::xml_node& details) {
    const std::string name = trimmed(xmlValue(details, "manufacturer") + " " + xmlValue(details, "model"));
    m_book.takeInstrument(name, xmlValue(details, "serialNumber"),
                          details ? m_book.file().lineOf(details) : 1);
  }

  void readObservations(const pugi::xml_node& group, const std::string& setUp) {
    readInstrument(xmlChild(group, "InstrumentDetails"));
    for (const pugi::xml_node part : group.children()) {
      const std::string_view kind = xmlName(part);
      m_line = m_book.file().lineOf(part);
      if (m_book.isFull(m_line)) return;
      if (kind == "RawObservation") readObservation(part, setUp);
      if (kind == "ReducedObservation")
        m_book.setAside(Phrase::of("a reduced observation, not a circle reading"), m_line);
      if (kind == "FieldNote") readNote(part);
    }
  }

  void readNote(const pugi::xml_node& part) {
    m_book.takeNote(trimmed(part.text().get()), m_book.file().lineOf(part));
  }

  void readObservation(const pugi::xml_node& observation, const std::string& groupSetUp) {
    const auto isTrue = [&observation](const char* name) {
      return isOneOf(lowerCase(xmlValue(observation, name)), {"true", "1"});
    };
    if (isTrue("unused") || lowerCase(xmlValue(observation, "status")) == "deleted")
      return m_book.setAsideSighting(Phrase::of("a deleted observation"), m_line);
    const std::string direct = xmlValue(observation, "directFace");
    XmlCircles circles{.horizontal = xmlValue(observation, "horizAngle"),
                       .vertical = xmlValue(observation, "zenithAngle"),
                       .unit = m_unit};
    if (circles.horizontal.empty() || circles.vertical.empty())
      return m_book.setAsideSighting(Phrase::of("an observation without one of the circles"), m_line);
    if (!direct.empty()) circles.face = isTrue("directFace") ? "1" : "2";
    RecordedSighting sighting;
    sighting.line = m_line;
    sighting.row.point = pointOf(observation);
    sighting.row.note = xmlValue(observation, "desc");
    if (const auto problem = enterCircles(circles, sighting))
      return m_book.refuse(m_line, 0, m_hasUnit ? *problem : withoutUnit(circles));
    takeDistance(observation, sighting);
    const std::string own = xmlValue(observation, "setupID");
    m_book.goTo(own.empty() ? groupSetUp : own, m_line);
    m_book.takeTime(xmlValue(observation, "timeStamp"));
    m_book.add(std::move(sighting));
  }

  static std::string withoutUnit(const XmlCircles& circles) {
    return Phrase::of(
        "%1 and %2 are not circle readings in radians, the default unit of a LandXML file: export the file "
        "with its unit of angles (angularUnit)",
        quotation(circles.horizontal), quotation(circles.vertical));
  }

  std::string pointOf(const pugi::xml_node& observation) const {
    const pugi::xml_node target = xmlChild(observation, "TargetPoint");
    if (std::string name = xmlValue(target, "name"); !name.empty()) return name;
    std::string reference = xmlValue(target, "pntRef");
    if (reference.empty()) reference = xmlValue(observation, "targetPntRef");
    if (const auto point = m_points.find(reference); point != m_points.end()) return point->second;
    if (!reference.empty()) return reference;
    const std::string id = xmlValue(observation, "targetID");
    return id.empty() ? xmlValue(target, "desc") : id;
  }

  void takeDistance(const pugi::xml_node& observation, RecordedSighting& sighting) {
    for (const bool isHorizontal : {false, true}) {
      const Result<double> distance =
          parseNumber(xmlValue(observation, isHorizontal ? "horizDistance" : "slopeDistance"));
      if (!distance || !(*distance * m_metres > 0)) continue;
      sighting.distanceM = *distance * m_metres;
      sighting.isDistanceHorizontal = isHorizontal;
      return m_book.setAsideForCheck(
          isHorizontal ? Phrase::of("horizontal distance") : Phrase::of("slope distance"), m_line);
    }
  }

  XmlBook m_book;
  AngleUnit m_unit = AngleUnit::Radians;
  bool m_hasUnit = false;                       ///< the file names its unit of angles; else radians apply
  double m_metres = 1;                          ///< per unit of length of the file; 0 if the unit is unknown
  std::map<std::string, std::string> m_points;  ///< oID by name
  std::size_t m_line = 1;
};

}  // namespace

bool looksLikeLandXml(std::string_view beginning) {
  return xmlRootName(beginning) == "LandXML";
}

Recording readLandXml(std::string_view text, const std::string& zeroPoint) {
  return LandXmlReader(text, zeroPoint).read();
}

}  // namespace alidade
