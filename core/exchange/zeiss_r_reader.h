#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"

namespace alidade {

/// Does a line begin like one of a Zeiss R4 or R5 file: `For R4|` or `For R5|`?
bool looksLikeZeissR(std::string_view line);

/// Reads a Zeiss R4 or R5 file, the predecessors of M5 (m5_reader.h). Sources: the Elta R user manual (data
/// formats M5, R4, R5, Rec500), and files of an Elta R55. The blocks of a line are separated by |:
///
///   For R5|Adr 0008|KR NTR1100|X 21.259 m |Y 59.620 m |Z 11.256 m |
///   For R4| KR NTR1100|…
///
/// The block before the values has a kind of two characters, a blank, a code of three characters and a point
/// number of four. Up to three values have a type and a unit each. R4 has no address. A line with Hz and
/// V1 (zenith angle) or V3 (height angle) is one sighting, with the code as its note. The units are gon, grd,
/// DEG, DMS and mil. Texts (TR) have the meaning of code blocks in GSI (gsi_reader.h); other lines of text,
/// coordinates (KR) and lengths are listed in `unused`. The file does not state the face.
Recording readZeissR(std::string_view text, const std::string& zeroPoint = {});

}  // namespace alidade
