#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/exchange/exact_angle.h"
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
// 2 gon, 3 decimal degrees and 4 DDD.MMSSs with 5 decimals, 5 mil with 4; 0, 1 and 6-8 are lengths. The input
// (position 5) is 1 where a value was keyed in and 4 where a program of the instrument worked it out. Levels
// have indices of three digits, as 331. Some programs write the decimal sign, one character more.

struct GsiWord {
  int index = 0;            ///< 11 point, 21 horizontal circle, 22 vertical circle, 41 code, 331 staff, …
  char unit = '.';          ///< position 6
  char sign = '+';          ///< + or −, as '-'
  std::string_view data;    ///< 8 or 16 characters, one more with a decimal sign, where `isWhole`
  std::size_t column = 0;   ///< of its first character, from 1
  char compensator = '.';   ///< position 4
  char input = '.';         ///< position 5
  bool isWhole = true;      ///< the data has one of the widths
  bool isNumbered = false;  ///< positions 3-6 are the number of a block: "110001"
};

/// One block of a line, which may hold several.
struct GsiBlock {
  std::vector<GsiWord> words;
  std::vector<GsiWord>
      torn;  ///< what is no word at all: `data` is all of it, `index` what it begins with or 0
};

/// Does the line begin as a GSI block does?
bool looksLikeGsi(std::string_view line);

/// The blocks of a line one after the other, as far as they can be made out: one begins at *, at a second
/// word 11, and at a word 41 with the number of a block. The width counts characters of the file: where it
/// was no UTF-8 a character of Chinese is two of them, and some programs count the bytes of UTF-8.
class GsiBlocks {
 public:
  explicit GsiBlocks(const TextLine& line);

  std::optional<GsiBlock> next();

 private:
  bool takeStar();
  bool beginsBlock(const GsiBlock& block) const;
  GsiWord takeWord();
  GsiWord takeTorn();
  void skip(std::size_t count);
  void skipBlanks();

  std::string_view m_rest;
  std::size_t m_column = 1;
  bool m_isMarked = false, m_hasStar = false;
};

/// The words of a line that is one sound block, as an instrument sends it.
std::variant<std::vector<GsiWord>, LineProblem> gsiWords(const TextLine& line);

/// The data without the zeros and blanks it is filled up with: "0000A110" is "A110", "00000000" is "0".
std::string gsiText(const GsiWord& word);

/// Where a written decimal sign stands in degrees, minutes and seconds: DDD.MMSSs or DDDMMSS.s.
enum class GsiPoint { BehindDegrees, BehindSeconds };

/// Behind the seconds, where more than three digits stand before the sign; else a word does not show it: its
/// neighbour in the block may.
std::optional<GsiPoint> gsiPoint(const GsiWord& word);

/// The angle of a word in a notation of `parseAngle`, every digit kept: `133.84650gon`, `123.45670°`,
/// `35°45'10.0"`; mil exactly as decimal degrees; a full turn is 0. Or the sentence why there is none.
std::variant<ExactAngle, LineProblem> gsiExactAngle(const GsiWord& word, std::size_t line,
                                                    std::optional<GsiPoint> point = {});

/// Likewise, its text alone.
std::variant<std::string, LineProblem> gsiAngle(const GsiWord& word, std::size_t line);

/// The length of a word in metres: unit 0 is mm, 1 a thousandth of a foot, 6, 7 and 8 have 4, 4 and 5
/// decimals of metres, feet and metres. Absent where it is none.
std::optional<double> gsiMetres(const GsiWord& word);

/// What an index stands for, for people; "word 99" where it is unknown.
std::string gsiWordName(int index);

}  // namespace alidade
