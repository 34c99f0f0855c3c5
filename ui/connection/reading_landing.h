#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/base/problem.h"
#include "core/connection/instrument_reading.h"
#include "core/evaluation/evaluation.h"
#include "core/session/entry_to_come.h"
#include "core/session/face.h"

namespace alidade::ui {

class SessionDocument;

/// The row or pointing zero that receives a reading of an instrument.
struct Landing {
  EntryToCome entry = {};               ///< the entry expected next by the protocol, or by the rows
  std::optional<std::size_t> row = {};  ///< row index, one past the last for a new row; absent: a zero
  std::string zero = {};                ///< "pointing_zero", "pointing_zero.face_2", …; empty: a row
  bool isProposed = false;              ///< this zero was not expected, but the reading points at it
  bool isChosen = false;                ///< the user selected the row, whatever entry is next

  std::size_t position() const { return entry.position; }
  Place place() const;  ///< the place of the horizontal reading
};

/// The expected zero or open row (`entryToCome`) while position `here` is in front; a row in the face of the
/// reading is preferred. Without a protocol, a reading that points at the zero is proposed as a further
/// sighting of the zero. Absent: no entry is expected.
std::optional<Landing> nextLanding(const Evaluation& evaluation, std::size_t here,
                                   const InstrumentReading& reading);

/// The landing of a reading in the row `row`, or in a new row after the last one.
Landing landingInRow(const Session& session, std::size_t position, std::size_t row);

/// Stores the reading with its additional data, as one undo step.
void land(SessionDocument& document, const Landing& landing, const InstrumentReading& reading);

/// The sighting of the pointing zero in field `zero`: "pointing_zero", "pointing_zero.face_2", …
ZeroSighting zeroAt(const Session& session, std::size_t position, const std::string& zero);

/// Converts both circles to face 1, in the session's kind of vertical circle.
FaceOneReading inFaceOne(const InstrumentReading& reading, const Session& session);

/// True if either circle differs from the expected one by more than `tolerance`.
bool isFar(const FaceOneReading& read, const FaceOneReading& expected, Angle tolerance);

/// True if both circles differ by at most `tolerance` from the position's pointing zero. Choose `tolerance`
/// smaller than the angle between any two targets.
bool looksAt(const InstrumentReading& reading, const Session& session, std::size_t position, Angle tolerance);

}  // namespace alidade::ui
