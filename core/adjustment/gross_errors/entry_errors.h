#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// The errors people make when they read a circle or type what was read.
enum class EntryError {
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

/// The share of this kind among all entry errors; the shares of all kinds add up to 1.
double entryErrorShare(EntryError error);

/// A text that may have been intended.
struct IntendedText {
  EntryError error = EntryError::OneDigitWrong;  ///< the more probable error if two lead to the same text
  std::string text;                              ///< in the style of the typed text
  double prior = 0;                              ///< the kind's share divided by the number of its texts
};

/// The possible intended texts of an angle, one entry error away from the typed text. Each occurs once, the
/// typed text never. Texts may be out of range. Errors of a degree, of minutes or of ten seconds need a text
/// in degrees, minutes and seconds; other texts only have digits changed.
std::vector<IntendedText> intendedTexts(std::string_view typed);

}  // namespace alidade
