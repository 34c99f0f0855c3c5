#include "core/exchange/xml_book.h"

#include <pugixml.hpp>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/visible_text.h"

namespace alidade {

void XmlBook::addSetUp(const std::string& id, std::string station) {
  const int uses = ++m_setUps[station];
  if (uses > 1) station += " (" + std::to_string(uses) + ")";
  m_stations[id] = std::move(station);
}

void XmlBook::goTo(const std::string& id, std::size_t line) {
  const auto station = m_stations.find(id);
  if (station == m_stations.end() || station->second == m_station) return;
  m_station = station->second;
  beginStation(m_station, line);
}

void XmlBook::takeInstrument(const std::string& name, const std::string& serial, std::size_t line) {
  const std::string what = Phrase::of("instrument");
  if (!name.empty()) keep(recording().instrumentName, name, what, line);
  if (!serial.empty()) keep(recording().instrumentSerial, serial, what, line);
}

void XmlBook::takeNote(const std::string& note, std::size_t line) {
  if (const auto mark = fieldMark(note)) return take(*mark);
  if (!note.empty()) setAside(Phrase::of("the note %1", quotation(note)), line);
}

void XmlBook::takeTime(std::string_view time) {
  std::string& date = recording().measuredOn;
  if (date.empty()) date = dateOfTime(time);
}

Recording XmlBook::finish(const std::string& format, const std::string& nothing) {
  if (const auto& problem = m_file.problem()) {
    refuse(problem->line, problem->column, problem->what);
  } else if (m_file.root() && recording().sightings.empty() && recording().problems.empty()) {
    refuse(1, 0, nothing);
  }
  return FieldBook::finish(format);
}

}  // namespace alidade
