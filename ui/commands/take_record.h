#pragma once

#include <string>

#include "core/base/result.h"
#include "core/session/instrument_record.h"

namespace alidade::ui {

class SessionDocument;

/// Copies a record into the session (`takeRecord`), in one step; `file` is the record's name without folder.
/// Without a change there is no step. Returns a sentence if the record belongs to another instrument.
std::optional<Problem> takeRecord(SessionDocument& document, const InstrumentRecord& record,
                                  const std::string& file);

}  // namespace alidade::ui
