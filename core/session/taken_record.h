#pragma once

#include <optional>
#include <string>

#include "core/base/problem.h"
#include "core/session/instrument_record.h"
#include "core/session/session.h"

namespace alidade {

// A session takes what a record knows by copying it, so that it stands alone.

/// Where what is taken says it is from: `instrument record t-1.alidade-instrument of 2026-03-01`. As it
/// stands in files, so never translated.
std::string citationOf(const NamedRecord& record);

/// Copies a record into the session's instrument: each σ that it states, each known size in place of the
/// session's own of the same number and of all that another record said, name, serial number, certificate
/// and traceability where the session has none; and names the record. `file`: the record's name, without
/// folder. Fails, the session as it was, where both state a serial number and these differ.
std::optional<Problem> takeRecord(Session& session, const InstrumentRecord& record, const std::string& file);

/// The record that says of the instrument what the session does. The day is that of the session's record
/// where it has one, else that of the measurement.
InstrumentRecord recordOf(const Session& session);

}  // namespace alidade
