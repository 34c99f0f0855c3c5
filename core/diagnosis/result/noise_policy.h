#pragma once

namespace alidade::noise_policy {

// The prior of the scatter of readings, in a session and in a series.

inline constexpr double knownTo = 0.1;            ///< relative uncertainty of the stated σ
inline constexpr double least = 1.25, most = 20;  ///< range of larger noise, in stated σ
inline constexpr double odds = 0.04;              ///< prior odds of larger noise

}  // namespace alidade::noise_policy
