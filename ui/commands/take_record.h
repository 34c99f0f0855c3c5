#pragma once

#include <string>

#include "core/base/result.h"
#include "core/session/instrument_record.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Replaces the session's instrument, including its known sizes.
class ChangeInstrument : public JournalledCommand {
 public:
  ChangeInstrument(SessionDocument& document, Instrument instrument, const QString& text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;

  Instrument m_before, m_after;
};

/// Copies a record into the session (`takeRecord`), in one step; `file` is the record's name without folder.
/// Without a change there is no step. Returns a sentence if the record belongs to another instrument.
std::optional<Problem> takeRecord(SessionDocument& document, const InstrumentRecord& record,
                                  const std::string& file);

}  // namespace alidade::ui
