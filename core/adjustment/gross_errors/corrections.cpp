#include "core/adjustment/gross_errors/corrections.h"

#include <utility>

#include "core/session/row_fields.h"
#include "core/session/row_order.h"

namespace alidade {

namespace {

struct Column {
  const char* field;
  std::string Reading::*text;
};

constexpr Column horizontal{"horizontal", &Reading::horizontal}, vertical{"vertical", &Reading::vertical},
    slider{"slider", &Reading::slider}, face{"face", &Reading::face};

class ReadingCorrections {
 public:
  ReadingCorrections(const Session& session, std::size_t position, std::size_t row)
      : m_readings(session.positions[position].readings), m_position(position), m_row(row) {}

  std::vector<Correction> all() {
    for (const Column& column : {horizontal, vertical, slider}) addIntendedTexts(column);
    addCirclesSwapped();
    addOtherFace();
    for (const std::size_t other : neighbours()) addExchanges(other);
    return std::move(m_corrections);
  }

 private:
  void change(Correction& correction, std::size_t row, const Column& column, const std::string& text) const {
    correction.changes.push_back({Place{.position = m_position, .reading = row, .field = column.field}, text,
                                  m_readings[row].*column.text});
    const auto [changed, isNew] = correction.rows.try_emplace(row, m_readings[row]);
    changed->second.*column.text = text;
  }

  void addIntendedTexts(const Column& column) {
    // An error has the same prior in each of the three columns.
    for (const IntendedText& intended : intendedTexts(m_readings[m_row].*column.text)) {
      Correction correction{intended.error, intended.prior, {}, {}};
      change(correction, m_row, column, intended.text);
      m_corrections.push_back(std::move(correction));
    }
  }

  void addCirclesSwapped() {
    const Reading& reading = m_readings[m_row];
    if (reading.horizontal == reading.vertical) return;
    Correction correction{EntryError::CirclesSwapped, entryErrorShare(EntryError::CirclesSwapped), {}, {}};
    change(correction, m_row, horizontal, reading.vertical);
    change(correction, m_row, vertical, reading.horizontal);
    m_corrections.push_back(std::move(correction));
  }

  void addOtherFace() {
    const auto typed = wholeEntry(faceRule, m_readings[m_row].face);
    if (!typed) return;
    Correction correction{EntryError::WrongFace, entryErrorShare(EntryError::WrongFace), {}, {}};
    change(correction, m_row, face, **typed == 1 ? "2" : "1");
    m_corrections.push_back(std::move(correction));
  }

  /// Rows at a distance of one; if the row states its face, also of two, as faces may alternate.
  std::vector<std::size_t> neighbours() const {
    std::vector<std::size_t> rows;
    for (const std::size_t distance : {std::size_t{1}, std::size_t{2}}) {
      if (distance == 2 && m_readings[m_row].face.empty()) break;
      for (const bool before : {true, false}) {
        if (before ? m_row < distance : m_row + distance >= m_readings.size()) continue;
        const std::size_t other = before ? m_row - distance : m_row + distance;
        if (!m_readings[other].excluded) rows.push_back(other);
      }
    }
    return rows;
  }

  void addExchanges(std::size_t other) {
    const double prior = entryErrorShare(EntryError::NeighbouringRow) / 6;
    for (const auto& columns : {std::vector{horizontal}, {vertical}, {horizontal, vertical}}) {
      Correction correction{EntryError::NeighbouringRow, prior, {}, {}};
      for (const Column& column : columns) {
        change(correction, m_row, column, m_readings[other].*column.text);
        change(correction, other, column, m_readings[m_row].*column.text);
      }
      m_corrections.push_back(std::move(correction));
    }
  }

  const std::vector<Reading>& m_readings;
  std::size_t m_position, m_row;
  std::vector<Correction> m_corrections;
};

}  // namespace

std::vector<Correction> correctionsOf(const Session& session, std::size_t position, std::size_t row) {
  return ReadingCorrections(session, position, row).all();
}

RowReader::RowReader(const Session& session) : m_firstSequences(firstSequences(session)) {
  m_alone.instrument = session.instrument;
  m_alone.environment = session.environment;
  m_alone.geometry = session.geometry;
  m_alone.model = session.model;
  for (const Position& position : session.positions)  // all positions, since together they decide which
                                                      // faces of a zero count
    m_alone.positions.push_back(
        {.axisDeg = position.axisDeg, .zero = position.zero, .readings = {}, .origin = {}});
}

std::optional<Sighting> RowReader::read(std::size_t position, std::size_t row, const Reading& reading) {
  Position& alone = m_alone.positions[position];
  alone.readings = {reading};
  // A point without a number is identified by its row.
  if (reading.point.empty()) alone.readings[0].point = std::to_string(row + 1);
  const Examined examined = examine(m_alone);
  alone.readings.clear();
  if (!examined.measurement) return std::nullopt;
  const auto& arcs = examined.measurement->arcs;
  const auto own = std::ranges::find(arcs, position, &ArcMeasurement::position);
  if (own == arcs.end() || own->sightings.size() != 1) return std::nullopt;
  Sighting sighting = own->sightings[0];
  sighting.row = row;
  sighting.sequence = m_firstSequences[position] + row;
  return sighting;
}

}  // namespace alidade
