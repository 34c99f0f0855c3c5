#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"

namespace alidade {

/// Reads a Leica GSI-8 or GSI-16 file (gsi_word.h). A block with words 21 and 22 is one sighting of the point
/// named by its word 11. Words 71-79, remarks, become the note; 12, 13 and 17 are the instrument and the
/// date. `unused` lists data that a session cannot hold: coordinates, blocks without angles, lines with # and
/// an instrument's messages, which begin with @, ? or %. Observers state axis, round, zero and station by
/// names, keyed in as point numbers or code blocks (word 41; a number may follow in word 42):
///
///   code 0 or AXIS0, 180 or AXIS180: the following sightings were taken at that position of the axis
///   code ROUND2, or ROUND and 2: the following sightings are of that round
///   code ZERO: the next sighting is of the pointing zero
///   point 0 or ZERO, or `zeroPoint`: the sighting is of the pointing zero
///   code STATION 5, STN, STANDPOINT: the following sightings were taken from that station; instruments
///     write code 21 or 2 instead, with the name in word 42
///
/// A block without angles but with a station's coordinates or the instrument's height (84-86, 88) names the
/// station by its point; word 16 alone names it, too. A session does not use stations and distances (31, 32).
///
/// POS and POSITION mean AXIS too, in any case. A code in the block of a sighting holds for this sighting and
/// the following ones. `unused` lists torn or unknown words that do not matter, and lines without words. A
/// line is refused if a circle, the point or a mark is torn. Remarks count the angles that were keyed in or
/// calculated (position 5 of their word), or had 60 seconds.
Recording readGsi(std::string_view text, const std::string& zeroPoint = {});

}  // namespace alidade
