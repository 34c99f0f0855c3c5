#include "ui/commands/change_effects.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "ui/document/session_document.h"
#include "ui/text/effect_text.h"

namespace alidade::ui {

namespace {

Place effectsPlace() {
  return {.field = "model.effects"};
}

std::string listed(const std::vector<std::string>& effects) {
  std::string text;
  for (const std::string& effect : effects) text += (text.empty() ? "" : ", ") + effect;
  return text;
}

}  // namespace

ChangeEffects::ChangeEffects(SessionDocument& document, std::vector<std::string> effects, const QString& text)
    : JournalledCommand(document, text),
      m_before(document.session().model.effects),
      m_after(std::move(effects)) {
  setEntries(journal().judge(effectsPlace(), listed(m_before), listed(m_after)));
}

void ChangeEffects::apply() {
  document().putEffects(m_after);
}
void ChangeEffects::revert() {
  document().putEffects(m_before);
}

std::vector<JournalEntry> ChangeEffects::allEntries() const {
  return journal().asStanding(effectsPlace(), listed(m_before), listed(m_after));
}

void setEffect(SessionDocument& document, const std::string& id, bool isEstimated) {
  std::vector<std::string> effects = document.session().model.effects;
  const bool wasEstimated = std::find(effects.begin(), effects.end(), id) != effects.end();
  if (wasEstimated == isEstimated) return;
  if (isEstimated) {
    effects.push_back(id);
  } else {
    effects.erase(std::remove(effects.begin(), effects.end(), id), effects.end());
  }
  const QString text = isEstimated ? QCoreApplication::translate("ChangeEffects", "Estimate %1")
                                   : QCoreApplication::translate("ChangeEffects", "Leave out %1");
  document.push(new ChangeEffects(document, std::move(effects), text.arg(effectName(id))));
}

void addEffects(SessionDocument& document, const std::vector<std::string>& ids) {
  std::vector<std::string> effects = document.session().model.effects;
  QStringList names;
  for (const std::string& id : ids) {
    if (std::find(effects.begin(), effects.end(), id) != effects.end()) continue;
    effects.push_back(id);
    names.append(effectName(id));
  }
  if (names.isEmpty()) return;
  const QString text = QCoreApplication::translate("ChangeEffects", "Estimate %1");
  document.push(new ChangeEffects(document, std::move(effects), text.arg(names.join(QStringLiteral(", ")))));
}

}  // namespace alidade::ui
