#pragma once

#include <vector>

#include "core/session/own_effect.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Sets the effects of one's own that the session brings.
class ChangeOwnEffects : public JournalledCommand {
 public:
  ChangeOwnEffects(SessionDocument& document, std::vector<OwnEffect> own, const QString& text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;

  std::vector<OwnEffect> m_before, m_after;
};

/// Puts an effect of one's own into the session, in the place of one with the same id.
void keepOwnEffect(SessionDocument& document, const OwnEffect& effect);

}  // namespace alidade::ui
