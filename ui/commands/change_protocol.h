#pragma once

#include <optional>
#include <string>

#include "core/session/sighting_protocol.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Replaces the protocol of the session; empty: none. The journal names it with its number of sightings.
class ChangeProtocol : public JournalledCommand {
 public:
  ChangeProtocol(SessionDocument& document, std::string protocol, const QString& text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;

  std::string m_before, m_after;
};

/// Sets the session's protocol, absent: none, and adds its missing positions, in one step. Does nothing if it
/// is already set.
void followProtocol(SessionDocument& document, const std::optional<SightingProtocol>& protocol);

}  // namespace alidade::ui
