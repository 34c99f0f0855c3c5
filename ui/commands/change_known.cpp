#include "ui/commands/change_known.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "ui/document/session_document.h"
#include "ui/text/known_text.h"

namespace alidade::ui {

namespace {

/// An entry for the number, still without texts.
KnownSize entryFor(const KnownRow& row) {
  const bool isOnly = row.effect->parameters.size() == 1;
  return {.effect = std::string(row.effect->id),
          .parameter = isOnly ? std::string() : std::string(row.parameter->name),
          .unit = std::string(row.parameter->unit)};
}

bool saysNothing(const KnownSize& size) {
  return std::ranges::all_of(knownCells, [&](const KnownCell& cell) { return (size.*cell.text).empty(); });
}

/// `trunnion_tilt: 12 ± 2 arcsec, certificate K-7`.
std::string said(const std::optional<KnownSize>& size) {
  if (!size) return {};
  std::string text = size->effect;
  if (!size->parameter.empty()) text += ' ' + size->parameter;
  text += ": " + (size->value.empty() ? "0" : size->value) + " ± " + size->sigma + ' ' + size->unit;
  return size->from.empty() ? text : text + ", " + size->from;
}

}  // namespace

ChangeKnown::ChangeKnown(SessionDocument& document, const KnownRef& ref, std::string_view member,
                         std::optional<KnownSize> after, const QString& text)
    : JournalledCommand(document, text), m_place(placeOf(ref, member)), m_after(std::move(after)) {
  if (const KnownSize* before = knownSize(document.session(), ref)) m_before = *before;
  setEntries(journal().judge(placeOf(ref), said(m_before), said(m_after)));
}

void ChangeKnown::apply() {
  document().putKnown(m_place, m_before.has_value(), m_after);
}
void ChangeKnown::revert() {
  document().putKnown(m_place, m_after.has_value(), m_before);
}

std::vector<JournalEntry> ChangeKnown::allEntries() const {
  return journal().asStanding(placeOf(knownAt(m_place).value().ref), said(m_before), said(m_after));
}

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
  const QString undoText = QCoreApplication::translate("ChangeKnown", "Change what is known of %1");
  document.push(new ChangeKnown(document, ref, cell.member,
                                isGone ? std::nullopt : std::optional(std::move(after)),
                                undoText.arg(knownName(session, row))));
}

}  // namespace alidade::ui
