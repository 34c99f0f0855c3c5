#include "ui/commands/change_own_effects.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "ui/commands/change_part.h"
#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

std::string listedOwn(const std::vector<OwnEffect>& effects) {
  std::string text;
  for (const OwnEffect& effect : effects)
    text += (text.empty() ? "" : "; ") + effect.id + ": " + effect.formula;
  return text;
}

}  // namespace

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
