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
//   positions 1-2: index; 3-6: number of the block, or "." and three digits: compensator, input, unit;
//   7: sign; 8-15 (GSI-8) or 8-23 (GSI-16): data; then a blank
//
// and a GSI-16 block starts with *. Numbers omit the decimal sign; the unit (position 6) implies its place:
// 2 gon, 3 decimal degrees and 4 DDD.MMSSs with 5 decimals, 5 mil with 4; 0, 1 and 6-8 are lengths. The input
// (position 5) is 1 if a value was keyed in and 4 if a program of the instrument calculated it. Levels have
// indices of three digits, such as 331. Some programs write the decimal sign, which adds a character.

struct GsiWord {
  int index = 0;            ///< 11 point, 21 horizontal circle, 22 vertical circle, 41 code, 331 staff, …
  char unit = '.';          ///< position 6
  char sign = '+';          ///< '+' or '-'
  std::string_view data;    ///< if `isWhole`, 8 or 16 characters, one more with a decimal sign
  std::size_t column = 0;   ///< column of its first character, from 1
  char compensator = '.';   ///< position 4
  char input = '.';         ///< position 5
  bool isWhole = true;      ///< the data has a width of the format
  bool isNumbered = false;  ///< positions 3-6 are the number of a block: "110001"
};

/// One block of a line, which may hold several.
struct GsiBlock {
  std::vector<GsiWord> words;
  std::vector<GsiWord>
      torn;  ///< text that does not form words: `data` is the text, `index` its leading digits or 0
};

/// Does the line begin like a GSI block?
bool looksLikeGsi(std::string_view line);

/// The recognisable blocks of a line in order. A block begins at *, at a second word 11, and at a word 41
/// with a block number. Widths count characters of the file: outside UTF-8 a Chinese character counts as two,
/// and some programs count UTF-8 bytes.
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

/// The words of a line as an instrument sends it; the first problem if any word is torn.
std::variant<std::vector<GsiWord>, LineProblem> gsiWords(const TextLine& line);

/// The data without leading zeros and blanks: "0000A110" is "A110", "00000000" is "0".
std::string gsiText(const GsiWord& word);

/// The place of a written decimal sign in degrees, minutes and seconds: DDD.MMSSs or DDDMMSS.s.
enum class GsiPoint { BehindDegrees, BehindSeconds };

/// BehindSeconds if more than three digits precede the decimal sign; else absent, and only another word of
/// the block can show the place.
std::optional<GsiPoint> gsiPoint(const GsiWord& word);

/// The angle of a word in a notation of `parseAngle`, with every digit of the word: `133.84650gon`,
/// `123.45670°`, `35°45'10.0"`; mil as exact decimal degrees; a full turn as 0. Else the reason of refusal.
std::variant<ExactAngle, LineProblem> gsiExactAngle(const GsiWord& word, std::size_t line,
                                                    std::optional<GsiPoint> point = {});

/// The angle of `gsiExactAngle` as text.
std::variant<std::string, LineProblem> gsiAngle(const GsiWord& word, std::size_t line);

/// The length of a word in metres. Unit 0 is 1 mm, 1 is 0.001 ft, 6 is 0.1 mm, 7 is 0.0001 ft and 8 is
/// 0.01 mm. Absent for other units, negative values and data with a written decimal sign.
std::optional<double> gsiMetres(const GsiWord& word);

/// The meaning of an index, for people; "word 99" if it is unknown.
std::string gsiWordName(int index);

}  // namespace alidade
