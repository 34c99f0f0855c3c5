#include "ui/document/session_delta.h"

#include <algorithm>
#include <iterator>

#include "ui/document/field.h"
#include "ui/document/known_entry.h"
#include "ui/document/readings_patch.h"

namespace alidade::ui {

namespace {

auto entryAt(auto& journal, std::size_t entry) {
  return std::next(journal.begin(), static_cast<std::ptrdiff_t>(std::min(entry, journal.size())));
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
      else if (place.field == "model.effects")
        m_news = after.model.effects;
      else
        m_news = after;
      break;
    case SessionChange::Kind::Readings:
      break;
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
  if (m_change.patch) {
    std::vector<Reading>& rows = session.positions[*m_change.place.position].readings;
    m_change.isReverted ? m_change.patch->revert(rows) : m_change.patch->apply(rows);
  } else if (const auto* effects = std::get_if<Effects>(&m_news)) {
    session.model.effects = *effects;
  } else if (const auto* known = std::get_if<Known>(&m_news)) {
    knownBy(session, knownAt(m_change.place)->ref.owner) = *known;
  } else if (const auto* text = std::get_if<std::string>(&m_news)) {
    fieldNamed(m_change.place.field)->at(session, m_change.place.position.value_or(0)) = *text;
  }
}

std::size_t SessionDelta::size() const {
  if (m_change.patch) return m_change.patch->rowCount() + m_change.patch->cellCount();
  const auto* whole = std::get_if<Session>(&m_news);
  std::size_t count = 0;
  for (std::size_t i = 0; whole && i < whole->positions.size(); ++i)
    count += whole->positions[i].readings.size();
  return count;
}

}  // namespace alidade::ui
