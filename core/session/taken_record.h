#pragma once

#include <optional>
#include <string>

#include "core/base/problem.h"
#include "core/session/instrument_record.h"
#include "core/session/session.h"

namespace alidade {

// A session copies the contents of a record, so that it is self-contained.

/// The source text of copied values: `instrument record t-1.alidade-instrument of 2026-03-01`. Files contain
/// the text, so it is never translated.
std::string citationOf(const NamedRecord& record);

/// Copies each σ that a record states, and its known sizes, into the session's instrument, and names the
/// record. The known sizes replace those of the same parameters and all sizes from an earlier record. Name,
/// serial number, certificate and traceability are copied where the session has none. `file`: the record's
/// name, without folder. Fails, changing nothing, if session and record state different serial numbers.
std::optional<Problem> takeRecord(Session& session, const InstrumentRecord& record, const std::string& file);

/// The record with the session's knowledge of the instrument. The date is that of the session's record if it
/// has one, else that of the measurement.
InstrumentRecord recordOf(const Session& session);

}  // namespace alidade
