#include "ui/models/entry_watch.h"

#include <cmath>

#include "core/base/angle_text.h"
#include "core/session/entry.h"
#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"
#include "ui/text/next_reading_text.h"

namespace alidade::ui {

EntryWatch::EntryWatch(SessionDocument& document, QObject* parent) : QObject(parent), m_document(document) {
  connect(&document, &SessionDocument::changed, this, &EntryWatch::look);
}

/// Checks a circle reading that was typed into an empty cell of the next expected row.
void EntryWatch::look(const SessionChange& change) {
  if (change.kind != SessionChange::Kind::Readings || change.inserted != 1 || !m_before) return;
  const std::size_t position = *change.place.position, row = *change.place.reading;
  if (position >= m_before->next.size() || position >= m_before->session.positions.size()) return;
  if (!m_before->next[position]) return;
  const NextReading& next = *m_before->next[position];
  const auto& rowsBefore = m_before->session.positions[position].readings;
  if (next.row != row) return;
  const Reading before = row < rowsBefore.size() ? rowsBefore[row] : Reading();
  const Reading& now = m_document.session().positions[position].readings[row];
  for (const ReadingColumn column : {ReadingColumn::Horizontal, ReadingColumn::Vertical}) {
    const auto text = readingText(column);
    if ((before.*text).empty() && !(now.*text).empty())
      emit entered(position, row, column, doubtOf(next, column, now.*text));
  }
}

QString EntryWatch::doubtOf(const NextReading& next, ReadingColumn column, const std::string& typed) const {
  const Result<Angle> read = parseAngle(typed);
  if (!read || !next.expected) return {};
  const Angle expected =
      column == ReadingColumn::Horizontal ? next.expected->horizontal : next.expected->vertical;
  const Angle off = Angle::fromRadians(std::abs(wrapped(*read - expected).radians()));
  if (off <= next.expected->tolerance) return {};
  const CircleUnit unit = circleUnitOf(m_document.session());
  return tr("%1: %2 was read where about %3 was expected. Look again.")
      .arg(sightingText(next.sighting), shownAngle(typed, unit), coarseAngleText(expected, unit));
}

}  // namespace alidade::ui
