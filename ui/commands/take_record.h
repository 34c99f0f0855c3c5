#pragma once

#include <string>

#include "core/base/result.h"
#include "core/session/instrument_record.h"

namespace alidade::ui {

class SessionDocument;

/// Copies a record into the session (`takeRecord`) as one undo step; adds no step if nothing changes. `file`:
/// the record's name without folder. Returns a problem if the record belongs to another instrument.
std::optional<Problem> takeRecord(SessionDocument& document, const InstrumentRecord& record,
                                  const std::string& file);

}  // namespace alidade::ui
