#include "ui/commands/change_session.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "ui/commands/change_part.h"
#include "ui/document/session_document.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

std::string listed(const std::vector<std::string>& effects) {
  std::string text;
  for (const std::string& effect : effects) text += (text.empty() ? "" : ", ") + effect;
  return text;
}

void change(SessionDocument& document, const std::vector<std::string>& effects, const QString& text) {
  using List = std::vector<std::string>;
  const auto partOf = [](Session& session) -> List& { return session.model.effects; };
  document.push(new ChangePart<List>(
      document, text, partOf, effects,
      changeAt({.field = "model.effects"}, listed(document.session().model.effects), listed(effects))));
}

std::string listedOwn(const std::vector<OwnEffect>& effects) {
  std::string text;
  for (const OwnEffect& effect : effects)
    text += (text.empty() ? "" : "; ") + effect.id + ": " + effect.formula;
  return text;
}

}  // namespace

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
  change(document, effects, text.arg(effectName(id)));
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
  change(document, effects, text.arg(listText(names)));
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
  const auto partOf = [](Session& session) -> std::vector<OwnEffect>& { return session.ownEffects; };
  PartChange change =
      changeAt({.field = "own_effects"}, listedOwn(document.session().ownEffects), listedOwn(own));
  document.push(new ChangePart<std::vector<OwnEffect>>(document, text.arg(qText(effect.name)), partOf,
                                                       std::move(own), std::move(change)));
}

}  // namespace alidade::ui
