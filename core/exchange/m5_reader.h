#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"

namespace alidade {

/// Does the line begin like one of a Zeiss or Trimble M5 file: `For M5|Adr`?
bool looksLikeM5(std::string_view line);

/// Reads a Zeiss or Trimble M5 file, as described in appendix B of the Trimble M3 user guide: 121 characters
/// to a line, CR LF included, in blocks separated by |,
///
///   columns 1-6: For M5; 8-16: Adr and address; 18-20 and 22-48: PI and a point, or TI or TO and a text;
///   50-71, 73-94, 96-117: three numbers, each with type (2), value (14) and unit (4); 119: e for an error
///
/// Bars, not columns, separate the blocks: some programs pad less. A line of a point (PI) with Hz and V1,
/// zenith angle, or V3, height angle, is one sighting. The units are gon, DEG, DMS (89.1413 is 89°14'13") and
/// mil. A heading line may state where the 12 characters of the point begin in columns 22-48; otherwise the
/// last word is the point. The text before the point becomes the note. Values 01 and 02 are the instrument's
/// name and serial number. Texts have the meaning of code blocks in GSI (gsi_reader.h), and points 0 and
/// ZERO, or `zeroPoint`, are the pointing zero. The file does not state the face. A set-up text such as KN
/// STAT begins a station; a point of code S before the first sighting names the station. `unused` lists data
/// that a session cannot hold. The address may be missing.
Recording readM5(std::string_view text, const std::string& zeroPoint = {});

}  // namespace alidade
