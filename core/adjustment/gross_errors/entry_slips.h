#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// The errors people make when they read a circle or type what was read.
enum class EntrySlip {
  DigitsSwapped,    ///< two adjacent digits
  OneDigitWrong,    ///< one digit
  DegreeOff,        ///< one degree too many or too few, with carries
  TenMinutesOff,    ///< ten minutes
  MinuteOff,        ///< one minute
  TenSecondsOff,    ///< ten seconds
  CirclesSwapped,   ///< horizontal and vertical reading in each other's column
  WrongFace,        ///< the other face was read
  NeighbouringRow,  ///< readings in each other's row
};

/// How often a slip is of this kind, before anything is known: their sum over all kinds is 1.
double slipShare(EntrySlip slip);

/// A text that may have been meant.
struct MeantText {
  EntrySlip slip = EntrySlip::OneDigitWrong;  ///< the likelier one where two lead to the same text
  std::string text;                           ///< in the style of the typed one
  double prior = 0;                           ///< the kind's share over the number of texts it leads to
};

/// What an angle may have been meant to be, one slip away from what was typed; each text once, the typed one
/// not among them. Texts need not be angles in range. One degree, minute or ten seconds off needs degrees,
/// minutes and seconds; other angles only have digits.
std::vector<MeantText> meantTexts(std::string_view typed);

}  // namespace alidade
