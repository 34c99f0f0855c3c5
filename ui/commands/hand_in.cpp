#include "ui/commands/hand_in.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/commands/explain_change.h"
#include "ui/document/field.h"
#include "ui/document/known_entry.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

const KnownCell* knownCellNamed(const std::string& member) {
  const auto found =
      std::ranges::find_if(knownCells, [&](const KnownCell& cell) { return cell.member == member; });
  return found == std::end(knownCells) ? nullptr : &*found;
}

bool isOfNumber(const KnownRow& row, const HalfTypedText& typed) {
  return row.effect && row.parameter && row.effect->id == typed.effect &&
         row.parameter->name == typed.parameter && !row.entry;
}

void handInKnown(SessionDocument& document, const HalfTypedText& typed) {
  const auto place = knownAt(typed.place);
  const KnownCell* cell = knownCellNamed(place ? place->member : typed.place.field);
  const std::vector<KnownRow> rows = knownRows(document.session());
  const auto row = std::ranges::find_if(
      rows, [&](const KnownRow& any) { return place ? any.entry == place->ref : isOfNumber(any, typed); });
  if (cell && row != rows.end()) typeKnown(document, *row, *cell, typed.text);
}

void handInReading(SessionDocument& document, const HalfTypedText& typed) {
  const auto column = std::ranges::find_if(allReadingColumns(), [&](const ReadingColumnInfo& info) {
    return info.field && info.field->key == typed.place.field;
  });
  if (column == std::end(allReadingColumns()) || !readingText(column->column)) return;
  std::optional<Reading> added;
  if (!typed.point.empty()) {
    added.emplace();
    added->point = typed.point;
    added->round = typed.round;
    added->face = typed.face;
  }
  ReadingsEditor(document, *typed.place.position)
      .setCell({*typed.place.reading, column->column}, typed.text, added);
}

void handInReason(SessionDocument& document, const HalfTypedText& typed) {
  const std::size_t entries = document.session().journal.size(),
                    first = typed.place.reading.value_or(entries);
  if (first >= entries || typed.count > entries - first) return;
  document.push(new ExplainChange(document, first, typed.count, typed.text));
}

void handInOne(SessionDocument& document, const HalfTypedText& typed) {
  const Place& place = typed.place;
  if (place.position && *place.position >= document.session().positions.size()) return;
  if (place.field == "journal") return handInReason(document, typed);
  if (place.reading) return handInReading(document, typed);
  if (!typed.effect.empty() || knownAt(place)) return handInKnown(document, typed);
  if (fieldNamed(place.field)) changeField(document, place, typed.text);
}

}  // namespace

void handIn(SessionDocument& document, const std::vector<HalfTypedText>& texts) {
  for (const HalfTypedText& typed : texts) handInOne(document, typed);
}

Session withHandedIn(const Session& session, const std::vector<HalfTypedText>& texts) {
  if (texts.empty()) return session;
  SessionDocument document;
  document.startWithRecorded(session);
  handIn(document, texts);
  return document.session();
}

}  // namespace alidade::ui
