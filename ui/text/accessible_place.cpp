#include "ui/text/accessible_place.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/document/field.h"
#include "ui/text/entry_text.h"
#include "ui/text/known_text.h"
#include "ui/text/list_text.h"
#include "ui/text/position_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int longestName = 20;

struct PlaceText {
  Q_DECLARE_TR_FUNCTIONS(PlaceText)
};

struct AccessibleCell {
  Q_DECLARE_TR_FUNCTIONS(AccessibleCell)
};

}  // namespace

QString accessibleRow(std::size_t row, const std::string& point) {
  const QString name = shortLine(qText(point).trimmed(), longestName);
  const QString number = QString::number(row + 1);
  return name.isEmpty() ? PlaceText::tr("row %1").arg(number)
                        : PlaceText::tr("row %1 (point %2)").arg(number, name);
}

QString accessiblePlace(const Session& session, const Place& place) {
  QStringList parts;
  if (place.position && *place.position < session.positions.size()) {
    const Position& position = session.positions[*place.position];
    parts.append(positionText(session, *place.position));
    if (place.reading && *place.reading < position.readings.size())
      parts.append(accessibleRow(*place.reading, position.readings[*place.reading].point));
  }
  if (const auto known = knownAt(place); known && knownSize(session, known->ref)) {
    parts.append(accessibleKnown(session, *known));
  } else if (!place.field.empty()) {
    const Field* field = place.reading ? nullptr : fieldNamed(place.field);
    parts.append(field ? QCoreApplication::translate("Field", field->noun) : qText(place.field));
  }
  return listText(parts);
}

QString accessibleCell(const QString& shown, const QString& title) {
  //: of a cell of a table: the name of its column
  return shown.isEmpty() ? AccessibleCell::tr("%1: empty").arg(title) : shown;
}

}  // namespace alidade::ui
