#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"

namespace alidade {

/// Does the line begin like a Sokkia SDR file, with the record 00NM and its version?
bool looksLikeSdr(std::string_view line);

/// Reads a Sokkia SDR33 or SDR2x file, as described in “Interfacing with the SOKKIA SDR Electronic Field
/// Book” (1999), chapter 3: a record is a line with a type (2 digits), its origin (2 letters) and fields at
/// fixed columns. The following records are used:
///
///   00: version 5-20; unit of angles 41 (1 decimal degrees, 2 gon); direction 46 (1 to the right)
///   01: instrument 6-21, serial number 22-27; vertical circle 51 (1 zenith, 2 horizon)
///   02: station 5-20 (SDR2x: 5-8)
///   09F1, 09F2, 09MD: a sighting in face 1, in face 2, with several distances; columns of SDR33 (SDR2x):
///         station 5-20 (5-8), point 21-36 (9-12), vertical 53-68 (23-32), horizontal 69-84 (33-42), note
///         85-100 (43-58)
///   13: a note with the meaning of code blocks in GSI (gsi_reader.h)
///
/// Points 0 and ZERO, or `zeroPoint`, are the pointing zero. Records 09MC hold corrected means and azimuths
/// instead of circle readings: `unused` lists them with all else that a session cannot hold, such as deleted
/// (DD) and unknown records. A file whose only observations are 09MC is refused. Mils are refused:
/// descriptions disagree on their code in the heading.
Recording readSdr(std::string_view text, const std::string& zeroPoint = {});

}  // namespace alidade
