#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/base/place.h"
#include "core/connection/instrument_reading.h"
#include "core/evaluation/evaluation.h"
#include "core/session/entry_to_come.h"
#include "core/session/face.h"

namespace alidade::ui {

class SessionDocument;

/// The target of a reading of an instrument, and the expected entry there.
struct Landing {
  EntryToCome entry = {};               ///< the next entry of the protocol, or of the rows
  std::optional<std::size_t> row = {};  ///< the one after the last is new; absent: a pointing zero
  std::string zero = {};                ///< "pointing_zero", "pointing_zero.face_2", …; empty: a row
  bool isProposed = false;              ///< not expected, but the reading points at this zero
  bool isChosen = false;                ///< by selecting the row, regardless of the next entry

  std::size_t position() const { return entry.position; }
  Place place() const;  ///< place of its horizontal reading
};

/// The target of the next expected entry (`entryToCome`) with position `here` in front: a zero or an open row
/// in the face of the reading. Without a protocol, a reading pointing at the zero is proposed as a further
/// sighting of it. Absent: no entry is expected.
std::optional<Landing> nextLanding(const Evaluation& evaluation, std::size_t here,
                                   const InstrumentReading& reading);

/// The landing of a reading in the row `row`, or in a new row after the last one.
Landing landingInRow(const Session& session, std::size_t position, std::size_t row);

/// Stores the reading with its additional data, as one undo step.
void land(SessionDocument& document, const Landing& landing, const InstrumentReading& reading);

/// The sighting in a pointing zero: "pointing_zero", "pointing_zero.face_2", …
ZeroSighting zeroAt(const Session& session, std::size_t position, const std::string& zero);

/// Converts both circles to face 1, in the session's kind of vertical circle.
FaceOneReading inFaceOne(const InstrumentReading& reading, const Session& session);

/// True if either circle differs from the expected one by more than `tolerance`.
bool isFar(const FaceOneReading& read, const FaceOneReading& expected, Angle tolerance);

/// True if the reading points at the pointing zero of the position. Any two targets at a bench differ by more
/// than `tolerance`.
bool looksAt(const InstrumentReading& reading, const Session& session, std::size_t position, Angle tolerance);

}  // namespace alidade::ui
