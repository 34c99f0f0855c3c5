#pragma once

#include <string>
#include <vector>

#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Sets the list of effects estimated in the model.
class ChangeEffects : public JournalledCommand {
 public:
  ChangeEffects(SessionDocument& document, std::vector<std::string> effects, const QString& text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;

  std::vector<std::string> m_before, m_after;
};

/// Adds the effect `id` to the estimated ones, or removes it; does nothing if unnecessary. Keeps all others,
/// including unknown ones.
void setEffect(SessionDocument& document, const std::string& id, bool isEstimated);

/// Adds those of `ids` that are not estimated yet, in one step.
void addEffects(SessionDocument& document, const std::vector<std::string>& ids);

}  // namespace alidade::ui
