#include "ui/text/session_difference.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/session/row_fields.h"
#include "core/session/session_file.h"
#include "ui/document/field.h"
#include "ui/text/accessible_place.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/known_text.h"

namespace alidade::ui {

namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Text)
};

class Comparison {
 public:
  Comparison(const Session& mine, const Session& theirs) : m_mine(mine), m_theirs(theirs) {}

  SessionDifference result() {
    compareFields();
    if (m_mine.model.effects != m_theirs.model.effects)
      add(m_mine, {.field = "model.effects"}, effects(m_mine), effects(m_theirs));
    for (const KnownOwner owner : {KnownOwner::Instrument, KnownOwner::Device}) compareKnown(owner);
    const std::size_t common = std::min(m_mine.positions.size(), m_theirs.positions.size());
    for (std::size_t i = 0; i < common; ++i) compareRows(i);
    for (std::size_t i = common; i < m_mine.positions.size(); ++i)
      add(m_mine, {.position = i}, rows(m_mine.positions[i]), {});
    for (std::size_t i = common; i < m_theirs.positions.size(); ++i)
      add(m_theirs, {.position = i}, {}, rows(m_theirs.positions[i]));
    if (m_found.count == 0 && writeSession(m_mine) != writeSession(m_theirs))
      add({Text::tr("entries that are not shown"), {}, {}});
    return std::move(m_found);
  }

 private:
  static QString effects(const Session& session) {
    QStringList names;
    for (const std::string& effect : session.model.effects) names.append(effectName(effect));
    return listText(names);
  }

  static QString rows(const Position& position) { return Text::tr("%1 rows").arg(position.readings.size()); }

  void compareFields() {
    const std::size_t common = std::min(m_mine.positions.size(), m_theirs.positions.size());
    for (const Field& field : allFields()) {
      Place place{.field = std::string(field.name)};
      if (!field.isOfPosition) compare(place, field.get(m_mine, 0), field.get(m_theirs, 0));
      for (std::size_t i = 0; field.isOfPosition && i < common; ++i) {
        place.position = i;
        compare(place, field.get(m_mine, i), field.get(m_theirs, i));
      }
    }
  }

  void compareKnown(KnownOwner owner) {
    const std::size_t entries = std::max(knownBy(m_mine, owner).size(), knownBy(m_theirs, owner).size());
    for (std::size_t i = 0; i < entries; ++i) {
      const KnownRef ref{owner, i};
      const KnownSize *mine = knownSize(m_mine, ref), *theirs = knownSize(m_theirs, ref);
      if (mine && theirs && *mine == *theirs) continue;
      add(mine ? m_mine : m_theirs, placeOf(ref), mine ? knownText(*mine) : QString(),
          theirs ? knownText(*theirs) : QString());
    }
  }

  void compareRows(std::size_t position) {
    const auto& mine = m_mine.positions[position].readings;
    const auto& theirs = m_theirs.positions[position].readings;
    const auto [left, right] = std::mismatch(mine.begin(), mine.end(), theirs.begin(), theirs.end());
    const auto first = static_cast<std::size_t>(left - mine.begin());
    std::size_t mineEnd = mine.size(), theirsEnd = theirs.size();
    while (mineEnd > first && theirsEnd > first && mine[mineEnd - 1] == theirs[theirsEnd - 1]) {
      --mineEnd;
      --theirsEnd;
    }
    const std::size_t common = std::min(mineEnd, theirsEnd);
    for (std::size_t row = first; row < common; ++row)
      compareCells({.position = position, .reading = row}, mine[row], theirs[row]);
    for (std::size_t row = common; row < mineEnd; ++row)
      add(m_mine, {.position = position, .reading = row}, whole(mine[row]), {});
    for (std::size_t row = common; row < theirsEnd; ++row)
      add(m_theirs, {.position = position, .reading = row}, {}, whole(theirs[row]));
  }

  void compareCells(Place place, const Reading& mine, const Reading& theirs) {
    for (const RowField& field : rowFields) {
      if (!field.text) continue;
      place.field = field.key;
      compare(place, mine.*field.text, theirs.*field.text);
    }
    place.field = rowField(&Reading::excluded).key;
    if (mine.excluded != theirs.excluded) add(m_mine, place, yesNo(mine.excluded), yesNo(theirs.excluded));
  }

  static QString yesNo(bool is) { return is ? Text::tr("yes") : Text::tr("no"); }

  /// The text of a row that is listed whole; for a row without angles, "a row".
  static QString whole(const Reading& reading) {
    const QString text = qText(reading.horizontal + "  " + reading.vertical).trimmed();
    return text.isEmpty() ? Text::tr("a row") : text;
  }

  void compare(const Place& place, const std::string& mine, const std::string& theirs) {
    if (mine != theirs) add(m_mine, place, qText(mine), qText(theirs));
  }

  void add(const Session& session, const Place& place, const QString& mine, const QString& theirs) {
    if (m_found.count < SessionDifference::most) return add({accessiblePlace(session, place), mine, theirs});
    ++m_found.count;
  }

  void add(EntryDifference entry) {
    m_found.entries.push_back(std::move(entry));
    ++m_found.count;
  }

  const Session &m_mine, &m_theirs;
  SessionDifference m_found;
};

}  // namespace

SessionDifference differenceOf(const Session& mine, const Session& theirs) {
  return Comparison(mine, theirs).result();
}

QString differenceCount(const SessionDifference& difference) {
  return difference.count == 1 ? Text::tr("1 entry differs")
                               : Text::tr("%1 entries differ").arg(difference.count);
}

}  // namespace alidade::ui
