#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "core/exchange/field_book.h"
#include "core/exchange/xml_file.h"

namespace alidade {

/// Builds a recording from a field book in XML. Stations are identified by the IDs of their set-ups.
class XmlBook : public FieldBook {
 public:
  XmlBook(std::string_view text, const std::string& zeroPoint) : FieldBook(zeroPoint), m_file(text) {}

  const XmlFile& file() const { return m_file; }

  /// Adds a set-up. A second set-up on a point, with another orientation of the circle, is named `K1 (2)`.
  void addSetUp(const std::string& id, std::string station);
  /// The sightings that follow belong to the set-up with this ID; an unknown ID changes nothing.
  void goTo(const std::string& id, std::size_t line);
  /// Empty texts are ignored.
  void takeInstrument(const std::string& name, const std::string& serial, std::size_t line);
  /// Takes a mark of axis, round or zero; lists any other note as unused.
  void takeNote(const std::string& note, std::size_t line);
  /// The first text with a date sets the day.
  void takeTime(std::string_view time);
  /// `nothing`: the reason of refusal if the file is valid but has no sighting.
  Recording finish(const std::string& format, const std::string& nothing);

 private:
  XmlFile m_file;
  std::map<std::string, std::string> m_stations;  ///< names by the IDs of the set-ups
  std::map<std::string, int> m_setUps;            ///< number of set-ups on each point
  std::string m_station;
};

}  // namespace alidade
