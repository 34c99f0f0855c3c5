#include "ui/text/journal_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

#include "core/base/problem.h"
#include "core/wording/journal.h"
#include "ui/document/reading_column.h"
#include "ui/text/accessible_place.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

/// The noun of a row's field. `excluded` is called "use", since its texts are “used” and “excluded”.
QString rowNoun(const std::string& name) {
  const RowField* field = rowFieldNamed(name);
  return field && field->flag ? QCoreApplication::translate("ReadingColumn", infoOf(ReadingColumn::Used).noun)
                              : rowFieldName(name);
}

}  // namespace

QString journalPlace(const JournalEntry& entry) {
  static const QRegularExpression pattern(
      QStringLiteral("^positions\\[(\\d+)\\](?:\\.readings\\[(\\d+)\\])?(?:\\.(.+))?$"));
  const auto match = pattern.match(qText(entry.place));
  if (!match.hasMatch()) return sessionFieldName(entry.place);
  QStringList parts{visibleLine(entry.axis) + u'°'};
  const bool isOfRow = !match.captured(2).isEmpty();
  if (isOfRow) parts.append(accessibleRow(match.captured(2).toULongLong(), entry.point));
  if (const std::string field = match.captured(3).toStdString(); !field.empty())
    parts.append(isOfRow ? rowNoun(field) : sessionFieldName(field));
  return listText(parts);
}

QString changeText(const JournalEntry& entry, const Session& session) {
  QStringList parts{visibleLine(reasonText(entry, session))};
  if (!entry.by.empty()) parts.append(shortLine(entry.by, 60));
  parts.append(visibleLine(timeText(entry.at)) + QStringLiteral(" UTC"));
  return listText(parts);
}

const JournalEntry* lastChange(const Session& session, std::size_t position, std::size_t row,
                               const RowField& field) {
  const std::vector<Reading>& rows = session.positions.at(position).readings;
  const std::string& now = rows.at(row).*field.text;
  const std::string name = '.' + std::string(field.key);
  const std::string of = Place{.position = position}.path() + ".readings[";
  const auto found = std::find_if(session.journal.rbegin(), session.journal.rend(), [&](const auto& entry) {
    return entry.to == now && entry.point == rows[row].point && entry.round == rows[row].round &&
           entry.face == rows[row].face && entry.place.starts_with(of) && entry.place.ends_with(name);
  });
  return found == session.journal.rend() ? nullptr : &*found;
}

}  // namespace alidade::ui
