#include "ui/document/session_delta.h"

#include <algorithm>
#include <iterator>

#include "ui/document/field.h"
#include "ui/document/known_entry.h"

namespace alidade::ui {

namespace {

auto rowAt(auto& rows, std::size_t row) {
  return std::next(rows.begin(), static_cast<std::ptrdiff_t>(row));
}

auto entryAt(auto& journal, std::size_t entry) {
  return rowAt(journal, std::min(entry, journal.size()));
}

void replaceRows(std::vector<Reading>& rows, const SessionChange& change, const std::vector<Reading>& news) {
  const std::size_t first = *change.place.reading, kept = std::min(change.removed, news.size());
  std::copy_n(news.begin(), kept, rowAt(rows, first));
  if (change.removed > kept)
    rows.erase(rowAt(rows, first + kept), rowAt(rows, first + change.removed));
  else
    rows.insert(rowAt(rows, first + kept), rowAt(news, kept), news.end());
}

}  // namespace

SessionDelta::SessionDelta(const Session& after, const SessionChange& change)
    : m_change(change), m_journal(entryAt(after.journal, change.journalKept), after.journal.end()) {
  const Place& place = change.place;
  switch (change.kind) {
    case SessionChange::Kind::Field:
      if (fieldNamed(place.field))
        m_news = fieldText(after, place);
      else if (const auto known = knownAt(place))
        m_news = knownBy(after, known->ref.owner);
      else
        m_news = after.model.effects;
      break;
    case SessionChange::Kind::Readings: {
      const Rows& rows = after.positions[*place.position].readings;
      m_news = Rows(rowAt(rows, *place.reading), rowAt(rows, *place.reading + change.inserted));
      break;
    }
    case SessionChange::Kind::Everything:
    case SessionChange::Kind::Positions:
      m_news = after;
  }
}

void SessionDelta::applyTo(Session& session) const {
  if (const auto* whole = std::get_if<Session>(&m_news)) {
    session = *whole;
    return;
  }
  session.journal.erase(entryAt(session.journal, m_change.journalKept), session.journal.end());
  session.journal.insert(session.journal.end(), m_journal.begin(), m_journal.end());
  if (const auto* effects = std::get_if<Effects>(&m_news)) {
    session.model.effects = *effects;
  } else if (const auto* known = std::get_if<Known>(&m_news)) {
    knownBy(session, knownAt(m_change.place)->ref.owner) = *known;
  } else if (const auto* text = std::get_if<std::string>(&m_news)) {
    fieldNamed(m_change.place.field)->at(session, m_change.place.position.value_or(0)) = *text;
  } else {
    replaceRows(session.positions[*m_change.place.position].readings, m_change, std::get<Rows>(m_news));
  }
}

std::size_t SessionDelta::rowCount() const {
  if (const auto* rows = std::get_if<Rows>(&m_news)) return rows->size();
  const auto* whole = std::get_if<Session>(&m_news);
  std::size_t count = 0;
  for (std::size_t i = 0; whole && i < whole->positions.size(); ++i)
    count += whole->positions[i].readings.size();
  return count;
}

}  // namespace alidade::ui
