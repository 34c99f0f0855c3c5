#include "ui/commands/change_own_effects.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

Place ownPlace() {
  return {.field = "own_effects"};
}

std::string listed(const std::vector<OwnEffect>& effects) {
  std::string text;
  for (const OwnEffect& effect : effects)
    text += (text.empty() ? "" : "; ") + effect.id + ": " + effect.formula;
  return text;
}

}  // namespace

ChangeOwnEffects::ChangeOwnEffects(SessionDocument& document, std::vector<OwnEffect> own, const QString& text)
    : JournalledCommand(document, text), m_before(document.session().ownEffects), m_after(std::move(own)) {
  setEntries(journal().judge(ownPlace(), listed(m_before), listed(m_after)));
}

void ChangeOwnEffects::apply() {
  document().putOwnEffects(m_after);
}
void ChangeOwnEffects::revert() {
  document().putOwnEffects(m_before);
}

std::vector<JournalEntry> ChangeOwnEffects::allEntries() const {
  return journal().asStanding(ownPlace(), listed(m_before), listed(m_after));
}

void keepOwnEffect(SessionDocument& document, const OwnEffect& effect) {
  std::vector<OwnEffect> own = document.session().ownEffects;
  const auto same = std::ranges::find(own, effect.id, &OwnEffect::id);
  if (same == own.end())
    own.push_back(effect);
  else if (*same == effect)
    return;
  else
    *same = effect;
  const QString text = QCoreApplication::translate("ChangeOwnEffects", "Keep the effect %1");
  document.push(new ChangeOwnEffects(document, std::move(own), text.arg(qText(effect.name))));
}

}  // namespace alidade::ui
