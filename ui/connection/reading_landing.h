#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/base/place.h"
#include "core/connection/instrument_reading.h"
#include "core/session/entry_to_come.h"
#include "core/session/face.h"
#include "ui/jobs/evaluation.h"

namespace alidade::ui {

class SessionDocument;

/// Where a reading of an instrument goes, and what was asked for there.
struct Landing {
  EntryToCome asked = {};               ///< what the protocol has next, or what the rows have
  std::optional<std::size_t> row = {};  ///< the one after the last: a new one; absent: a pointing zero
  std::string zero = {};                ///< "pointing_zero", "pointing_zero.face_2", …; empty: a row
  bool isProposed = false;              ///< nobody asked for this zero; the reading looks at it
  bool isChosen = false;                ///< by selecting the row: no matter what comes next

  std::size_t position() const { return asked.position; }
  Place place() const;  ///< of its horizontal reading
};

/// Where it goes that is asked for next (`entryToCome`) while `here` is in front, in the face that was read:
/// a zero into that of its face, a reading into the row of its face where that is open. Without a protocol a
/// reading that looks at the pointing zero is proposed as a further sighting of it. Absent: no place is asked
/// for.
std::optional<Landing> nextLanding(const Evaluation& evaluation, std::size_t here,
                                   const InstrumentReading& reading);

/// Into that row, or behind the last one.
Landing landingInRow(const Session& session, std::size_t position, std::size_t row);

/// Puts it there as one step to undo, with all that came with it.
void land(SessionDocument& document, const Landing& landing, const InstrumentReading& reading);

/// The sighting that stands in a pointing zero: "pointing_zero", "pointing_zero.face_2", …
ZeroSighting zeroAt(const Session& session, std::size_t position, const std::string& zero);

/// Both circles as face 1 reads them, in the session's kind of vertical circle.
FaceOneReading inFaceOne(const InstrumentReading& reading, const Session& session);

/// Is either circle farther from what is expected than `tolerance`?
bool isFar(const FaceOneReading& read, const FaceOneReading& expected, Angle tolerance);

/// Does it look at that sighting of the pointing zero? No two targets of a bench are as near to each other as
/// `tolerance`.
bool looksAt(const InstrumentReading& reading, const Session& session, std::size_t position, Angle tolerance);

}  // namespace alidade::ui
