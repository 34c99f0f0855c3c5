#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "core/exchange/field_book.h"
#include "core/exchange/xml_file.h"

namespace alidade {

/// A recording in the making from a field book in XML. Stations are told by the IDs of their set-ups.
class XmlBook : public FieldBook {
 public:
  XmlBook(std::string_view text, const std::string& zeroPoint) : FieldBook(zeroPoint), m_file(text) {}

  const XmlFile& file() const { return m_file; }

  /// A point may be set up on again, with another orientation of the circle: its second set-up is `K1 (2)`.
  void addSetUp(const std::string& id, std::string station);
  /// What follows was sighted from that set-up; an unknown one changes nothing.
  void goTo(const std::string& id, std::size_t line);
  /// Empty ones say nothing.
  void takeInstrument(const std::string& name, const std::string& serial, std::size_t line);
  /// A mark of axis, round or zero, or a note that a session has no place for.
  void takeNote(const std::string& note, std::size_t line);
  /// The day is that of the first time that holds one.
  void takeTime(std::string_view time);
  /// `nothing`: why the file is refused where it is sound and no sighting was read.
  Recording finish(const std::string& format, const std::string& nothing);

 private:
  XmlFile m_file;
  std::map<std::string, std::string> m_stations;  ///< their names by the IDs of the set-ups
  std::map<std::string, int> m_setUps;            ///< how often each point was set up on
  std::string m_station;
};

}  // namespace alidade
