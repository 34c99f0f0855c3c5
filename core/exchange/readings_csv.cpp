#include "core/exchange/readings_csv.h"

#include <algorithm>
#include <map>
#include <vector>

#include "core/exchange/csv_text.h"
#include "core/session/measurement.h"
#include "core/session/row_fields.h"

namespace alidade {

namespace {

/// The turn of each position: its number among the positions at the same axis.
std::vector<int> turnsOf(const Session& session) {
  std::map<std::string, int> count;
  std::vector<int> turns;
  for (const Position& position : session.positions) {
    const Result<int> axis = axisEntry(position.axisDeg);
    turns.push_back(++count[axis ? std::to_string(*axis) : position.axisDeg]);
  }
  return turns;
}

class ReadingsTable {
 public:
  explicit ReadingsTable(const Session& session)
      : m_session(session),
        m_turns(turnsOf(session)),
        m_hasTurns(std::ranges::any_of(m_turns, [](int turn) { return turn > 1; })),
        m_hasCompensator(hasCompensatorTexts(session)),
        m_hasArrival(hasArrivalTexts(session)),
        m_csv(titles()) {}

  std::string written() {
    for (m_position = 0; m_position < m_session.positions.size(); ++m_position) {
      const Position& position = m_session.positions[m_position];
      addZero("1", firstSighting(position.zero));
      addZeros(position.zero, false);
      for (std::size_t row = 0; row < position.readings.size(); ++row)
        if (!isBlank(position.readings[row])) addRow(position.readings[row], std::to_string(row + 1));
      addZeros(position.zero, true);
    }
    return m_csv.text();
  }

 private:
  std::vector<std::string_view> titles() const {
    std::vector<std::string_view> names{"axis"};
    if (m_hasTurns) names.emplace_back("turn");
    for (const std::string_view name : {"point", "round", "face", "horizontal"}) names.push_back(name);
    names.push_back(verticalName());
    names.emplace_back("slider");
    if (m_hasCompensator)
      for (const auto text : compensatorTexts) names.push_back(rowField(text).key);
    if (m_hasArrival)
      for (const auto text : arrivalTexts) names.push_back(rowField(text).key);
    for (const std::string_view name : {"excluded", "note"}) names.push_back(name);
    return names;
  }

  std::string_view verticalName() const {
    const Result<VerticalCircle> circle = verticalCircleEntry(m_session.geometry.verticalCircle);
    return keyOf(circle ? *circle : VerticalCircle::Zenith);
  }

  CsvText& beginRow() {
    m_csv.typed(m_session.positions[m_position].axisDeg);
    if (m_hasTurns) m_csv.count(m_turns[m_position]);
    return m_csv;
  }

  void addZeros(const PointingZero& zero, bool isAfter) {
    for (const ZeroSlot& slot : furtherZeros)
      if (slot.isAfter == isAfter) addZero(slot.face == 2 ? "2" : "1", zero.*slot.sighting);
  }

  void addZero(std::string_view face, const ZeroSighting& zero) {
    if (zero.horizontal.empty() && zero.vertical.empty()) return;
    beginRow().word("ZERO").word("").word(face).typed(zero.horizontal).typed(zero.vertical).word("");
    if (m_hasCompensator) m_csv.word("").word("").word("");
    if (m_hasArrival)
      for (const auto text : zeroArrivalTexts) m_csv.typed(zero.*text);
    m_csv.word("").word("").endRow();
  }

  void addRow(const Reading& row, const std::string& number) {
    const auto orUsual = [](const std::string& text, const RowField& field) {
      return text.empty() ? usualText(field) : text;
    };
    beginRow().typed(row.point.empty() ? number : row.point);
    m_csv.typed(orUsual(row.round, rowField(&Reading::round)));
    m_csv.typed(orUsual(row.face, rowField(&Reading::face)));
    m_csv.typed(row.horizontal).typed(row.vertical).typed(row.slider);
    if (m_hasCompensator)
      for (const auto text : compensatorTexts) m_csv.typed(row.*text);
    if (m_hasArrival)
      for (const auto text : arrivalTexts) m_csv.typed(row.*text);
    m_csv.word(row.excluded ? "yes" : "").typed(row.note).endRow();
  }

  const Session& m_session;
  std::vector<int> m_turns;
  bool m_hasTurns, m_hasCompensator, m_hasArrival;
  CsvText m_csv;
  std::size_t m_position = 0;
};

}  // namespace

std::string readingsCsv(const Session& session) {
  return ReadingsTable(session).written();
}

}  // namespace alidade
