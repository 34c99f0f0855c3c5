#pragma once

#include <string>

#include "core/base/result.h"
#include "core/session/instrument_record.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Puts another instrument in the place of the session's, all that is known of it included.
class ChangeInstrument : public JournalledCommand {
 public:
  ChangeInstrument(SessionDocument& document, Instrument instrument, const QString& text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;

  Instrument m_before, m_after;
};

/// Copies what a record says into the session (`takeRecord`), in one step; `file` is the record's name,
/// without folder. What would change nothing leaves no step. The sentence where the record is of another
/// instrument.
std::optional<Problem> takeRecord(SessionDocument& document, const InstrumentRecord& record,
                                  const std::string& file);

}  // namespace alidade::ui
