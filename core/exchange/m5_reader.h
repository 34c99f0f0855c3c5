#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"

namespace alidade {

/// Does the line begin as one of a Zeiss or Trimble M5 file does: `For M5|Adr`?
bool looksLikeM5(std::string_view line);

/// Reads a Zeiss or Trimble M5 file, as described in appendix B of the Trimble M3 user guide: 121 characters
/// to a line, CR LF among them, in blocks parted by |,
///
///   columns   1-6      8-16          18-20, 22-48            50-71, 73-94, 96-117        119
///             For M5   Adr, address  PI and a point, or      type (2), value (14) and    e: an error
///                                    TI or TO and a text     unit (4) of three numbers
///
/// The bars count, not the columns: some programs pad less. A line of a point (PI) with Hz and V1, zenith
/// angle, or V3, height angle, is one sighting; the units are gon, DEG, DMS (89.1413 is 89°14'13") and mil.
/// Where a line of the heading says in 22 where the point stands, its 12 characters are the point, else the
/// last word; what stands before it becomes the note. 01 and 02 are the instrument. Texts say what code
/// blocks say in GSI (gsi_reader.h), and points 0 and ZERO, or `zeroPoint`, are the pointing zero. The face
/// is not in the file. A text such as KN STAT, with which the instrument was stood up, begins a station, and
/// a point of the code S before its sightings names it. What a session has no place for is listed in
/// `unused`. A line may have no address.
Recording readM5(std::string_view text, const std::string& zeroPoint = {});

}  // namespace alidade
