#include "core/session/instrument_record.h"
#include "core/session/protocol_progress.h"
#include "core/session/session_file.h"
#include "core/session/sighting_protocol.h"
#include "core/session/taken_record.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

namespace {

/// Reads a record. It must be refused with a sentence, or unchanged after writing and reading.
template <typename Read, typename Write>
auto readAndWritten(std::string_view bytes, const Read& read, const Write& write) {
  auto record = read(bytes);
  if (!record) {
    require(!record.problem().what.empty(), "a record refused without words");
    return record;
  }
  const std::string written = write(*record);
  const auto again = read(written);
  require(static_cast<bool>(again), "a record that was written cannot be read");
  require(write(*again) == written, "a record that changes when it is read and written");
  return record;
}

void followProtocol(std::string_view bytes) {
  const Result<SightingProtocol> protocol = readAndWritten(bytes, readProtocol, writeProtocol);
  if (!protocol) return;
  const std::vector<PlannedSighting> sightings = sightingsInOrder(*protocol);
  require(sightings.size() <= mostSightings, "more sightings than a protocol may have");
  Session session = blankSession();
  session.protocol = protocolText(*protocol);
  const auto own = protocolOf(session);
  require(own && *own && sightingsInOrder(**own) == sightings, "a session that follows another protocol");
  const ProtocolProgress progress = progressOf(session, *protocol);
  require(progress.sightings.size() == sightings.size() && progress.taken == 0, "progress out of nothing");
  for (const PlannedSighting& sighting : sightings)
    require(sighting.isZero ? !zeroField(sighting).empty() : sighting.point >= 0, "a sighting of no place");
}

void takeInstrument(std::string_view bytes) {
  const Result<InstrumentRecord> record = readAndWritten(bytes, readInstrumentRecord, writeInstrumentRecord);
  if (!record) return;
  Session session = blankSession();
  require(!takeRecord(session, *record, "fuzzed.alidade-instrument"), "a blank session refuses a record");
  const Result<Session> taken = readSession(writeSession(session));
  require(taken && *taken == session, "a session that forgets the record it took");
  recordOf(session);
}

}  // namespace

void throwRecords(std::string_view bytes) {
  followProtocol(bytes);
  takeInstrument(bytes);
}

}  // namespace alidade::fuzz
