#pragma once

#include <optional>
#include <string>

#include "core/session/sighting_protocol.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Puts another protocol in the place of the one that the session follows; empty: none. The journal tells of
/// its name and how many sightings it has.
class ChangeProtocol : public JournalledCommand {
 public:
  ChangeProtocol(SessionDocument& document, std::string protocol, const QString& text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;

  std::string m_before, m_after;
};

/// Makes the session follow `protocol`, absent: none; and adds the positions that it has and the session
/// lacks, in one step. Nothing where the session does so already.
void followProtocol(SessionDocument& document, const std::optional<SightingProtocol>& protocol);

}  // namespace alidade::ui
