#pragma once

#include <optional>
#include <string>

#include "core/exchange/gsi_word.h"

namespace alidade {

// What a GSI word states about its angle. Characters 3 to 6 are the block's number, or a point followed by
//
//   4 compensator: 0 off, 1 and 3 on
//   5 input: 0 as measured, 1 keyed in, 2 measured with the corrections of the horizontal circle on, 3 with
//       these corrections off, 4 the result of a function
//   6 unit
//
// where a point replaces missing information. Source: GSI ONLINE for Leica TPS and DNA (Leica Geosystems,
// 2008), GSI word information.

struct GsiInformation {
  std::optional<bool> isCompensated = {};          ///< the compensator was on
  std::optional<bool> isHorizontalCorrected = {};  ///< corrected for standing axis, collimation, tilting axis
  bool isKeyedIn = false;                          ///< typed on the instrument instead of measured
  bool isComputed = false;                         ///< the result of a function of the instrument
};

GsiInformation gsiInformation(const GsiWord& word);

/// The corrections that the words of both circles state, in the notation of a row; empty if not fully known.
std::string gsiCorrections(const GsiInformation& horizontal, const GsiInformation& vertical);

/// The reason why the instrument does not guarantee one of these angles; empty if it does.
std::string gsiReservation(const GsiInformation& horizontal, const GsiInformation& vertical);

}  // namespace alidade
