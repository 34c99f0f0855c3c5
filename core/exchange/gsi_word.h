#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/exchange/recording.h"
#include "core/exchange/text_lines.h"

namespace alidade {

// Leica Geo Serial Interface, as described in the data format chapter of the TPS1100 user manual: a block is
// a line of words of fixed width,
//
//   position   1-2      3-6                              7      8-15 (GSI-8) or 8-23 (GSI-16)   then
//              index    block number, or "." and three   sign   data                            blank
//                       digits: index, input, unit
//
// and a GSI-16 block starts with *. Numbers have no decimal sign; the unit (position 6) places it:
// 2 gon, 3 decimal degrees and 4 DDD.MMSSs with 5 decimals, 5 mil with 4; 0, 1 and 6-8 are lengths.

struct GsiWord {
  int index = 0;           ///< 11 point, 21 horizontal circle, 22 vertical circle, 41 code, …
  char unit = '.';         ///< position 6
  char sign = '+';         ///< + or −, as '-'
  std::string_view data;   ///< 8 or 16 characters
  std::size_t column = 0;  ///< of its first character, from 1
};

/// Does the line begin as a GSI block does?
bool looksLikeGsi(std::string_view line);

/// The words of a block. A word may be wider than the line's other words; what counts is that it ends at a
/// blank or with the line.
std::variant<std::vector<GsiWord>, LineProblem> gsiWords(const TextLine& line);

/// The data without the zeros and blanks it is filled up with: "0000A110" is "A110", "00000000" is "0".
std::string gsiText(const GsiWord& word);

/// The angle of a word in a notation of `parseAngle`, every digit kept: `133.84650gon`, `123.45670°`,
/// `35°45'10.0"`; mil exactly as decimal degrees. Or the sentence why there is none.
std::variant<std::string, LineProblem> gsiAngle(const GsiWord& word, std::size_t line);

/// The length of a word in metres: unit 0 is mm, 1 a thousandth of a foot, 6, 7 and 8 have 4, 4 and 5
/// decimals of metres, feet and metres. Absent where it is none.
std::optional<double> gsiMetres(const GsiWord& word);

/// What an index stands for, for people; "word 99" where it is unknown.
std::string gsiWordName(int index);

}  // namespace alidade
