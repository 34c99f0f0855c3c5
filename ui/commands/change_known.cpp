#include "ui/commands/change_session.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "ui/commands/change_part.h"
#include "ui/document/session_document.h"
#include "ui/text/known_text.h"

namespace alidade::ui {

namespace {

/// A new entry for the parameter of the row, still without texts.
KnownSize entryFor(const KnownRow& row) {
  const bool isOnly = row.effect->parameters.size() == 1;
  return {.effect = std::string(row.effect->id),
          .parameter = isOnly ? std::string() : std::string(row.parameter->name),
          .unit = std::string(row.parameter->unit)};
}

bool saysNothing(const KnownSize& size) {
  return std::ranges::all_of(knownCells, [&](const KnownCell& cell) { return (size.*cell.text).empty(); });
}

/// The text for the journal, such as `trunnion_tilt: 12 ± 2 arcsec, certificate K-7`. For display,
/// `contentText` (core/wording/journal.h) replaces identifiers by names.
std::string saidOf(const KnownSize& size) {
  std::string text = size.effect;
  if (!size.parameter.empty()) text += ' ' + size.parameter;
  text += ": " + (size.value.empty() ? "0" : size.value) + " ± " + size.sigma + ' ' + size.unit;
  return size.from.empty() ? text : text + ", " + size.from;
}

/// The list with `entry` at `index`: replaced, appended, or removed if all its texts are empty.
std::vector<KnownSize> listWith(std::vector<KnownSize> list, std::size_t index, const KnownSize& entry) {
  if (index == list.size())
    list.push_back(entry);
  else if (saysNothing(entry))
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
  else
    list[index] = entry;
  return list;
}

}  // namespace

void typeKnown(SessionDocument& document, const KnownRow& row, const KnownCell& cell,
               const std::string& text) {
  const Session& session = document.session();
  const KnownRef ref =
      row.entry.value_or(KnownRef{ownerOf(*row.effect), knownBy(session, ownerOf(*row.effect)).size()});
  const KnownSize* before = row.entry ? knownSize(session, ref) : nullptr;
  KnownSize after = before ? *before : entryFor(row);
  const bool isSame = after.*cell.text == text;
  after.*cell.text = text;
  const bool isGone = saysNothing(after);
  if (isGone ? !before : isSame) return;
  const QString undoText = QCoreApplication::translate("ChangeKnown", "Change known size of %1");
  PartChange change = changeAt(placeOf(ref), before ? saidOf(*before) : std::string(),
                               isGone ? std::string() : saidOf(after));
  change.forViews.place = placeOf(ref, cell.member);
  document.push(new ChangePart<std::vector<KnownSize>>(
      document, undoText.arg(knownName(session, row)),
      [owner = ref.owner](Session& any) -> std::vector<KnownSize>& { return knownBy(any, owner); },
      listWith(knownBy(session, ref.owner), ref.index, after), std::move(change)));
}

}  // namespace alidade::ui
