#include "ui/text/accessible_place.h"

#include <QCoreApplication>
#include <QStringList>
#include <charconv>
#include <string_view>

#include "ui/document/field.h"
#include "ui/document/reading_column.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/known_text.h"
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

/// The name of an entry of the session's own effects, such as `own_effects[1].formula`; empty for any other
/// field.
QString ownEffectName(std::string_view field) {
  constexpr std::string_view list = "own_effects[";
  if (!field.starts_with(list)) return {};
  const std::string_view entry = field.substr(list.size());
  std::size_t index = 0;
  if (std::from_chars(entry.data(), entry.data() + entry.size(), index).ec != std::errc()) return {};
  const QString number = QString::number(index + 1);
  if (entry.find("].formula") != entry.npos) return PlaceText::tr("formula of own effect %1").arg(number);
  if (entry.find("].parameters") != entry.npos)
    return PlaceText::tr("plausible sizes of own effect %1").arg(number);
  return PlaceText::tr("own effect %1").arg(number);
}

/// The name of an entry of the known sizes, whatever its effect; empty for any other field.
QString knownEntryName(const std::string& name) {
  const auto known = knownAt({.field = name});
  if (!known) return {};
  return known->ref.owner == KnownOwner::Device ? PlaceText::tr("known value of the device")
                                                : PlaceText::tr("known value of the instrument");
}

}  // namespace

QString rowFieldName(const std::string& name) {
  const RowField* field = rowFieldNamed(name);
  if (!field) return visibleLine(qText(name));
  if (field->flag) return PlaceText::tr("excluded");
  return QCoreApplication::translate("ReadingColumn", infoOf(readingColumn(name)).noun);
}

QString sessionFieldName(const std::string& name) {
  const Field* field = fieldNamed(name.starts_with("protocol.") ? "protocol" : name);
  if (field) return QCoreApplication::translate("Field", field->noun);
  if (name == "model.effects") return PlaceText::tr("model effects");
  if (name == "own_effects") return PlaceText::tr("own effects");
  if (name == "readings") return PlaceText::tr("readings");
  for (const QString& entry : {ownEffectName(name), knownEntryName(name)})
    if (!entry.isEmpty()) return entry;
  return visibleLine(qText(name));
}

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
    parts.append(place.reading ? rowFieldName(place.field) : sessionFieldName(place.field));
  }
  return listText(parts);
}

QString problemText(const Session& session, const Problem& problem) {
  const QString place = accessiblePlace(session, problem.where);
  const QString what = qText(problem.what);
  if (place.isEmpty()) return what;
  //: a place and its problem, as a predicate ("is empty") and as a sentence
  return (what.startsWith(QStringLiteral("is ")) ? PlaceText::tr("%1 %2") : PlaceText::tr("%1: %2"))
      .arg(capitalised(place), what);
}

QString accessibleCell(const QString& shown, const QString& title) {
  //: of a cell of a table: the name of its column
  return shown.isEmpty() ? AccessibleCell::tr("%1: empty").arg(title) : shown;
}

}  // namespace alidade::ui
