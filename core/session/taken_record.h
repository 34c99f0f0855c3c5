#pragma once

#include <optional>
#include <string>

#include "core/base/problem.h"
#include "core/session/instrument_record.h"
#include "core/session/session.h"

namespace alidade {

// A session copies the contents of a record, so that it is self-contained.

/// The source text of copied values: `instrument record t-1.alidade-instrument of 2026-03-01`. Part of files,
/// so never translated.
std::string citationOf(const NamedRecord& record);

/// Copies a record into the session's instrument: each stated σ; each known size, in place of the session's
/// own of the same parameter and of all from another record; name, serial number, certificate and
/// traceability if the session has none. Also names the record. `file`: the record's name, without folder.
/// Fails, leaving the session unchanged, if both state a serial number and these differ.
std::optional<Problem> takeRecord(Session& session, const InstrumentRecord& record, const std::string& file);

/// The record with the session's knowledge of the instrument. The date is that of the session's record if it
/// has one, else that of the measurement.
InstrumentRecord recordOf(const Session& session);

}  // namespace alidade
