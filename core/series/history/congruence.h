#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/series/history/epoch.h"

namespace alidade {

// Tests whether a device has changed between two epochs. The fits, which have no reading in common, yield m
// numbers x₁ and x₂ each, with the covariances C₁ and C₂. C has f degrees of freedom:
//
//   d = x₂ − x₁, C = C₁ + C₂, T = dᵀ C⁻¹ d, T/m ~ F(m, f)
//
// (Pelzer 1971). O1 and O2 refer to the theodolite; they can be compared only between set-ups in the same
// place. (O1 − O2)/2 and the radii belong to the device.

/// The test whether numbers of two epochs differ.
struct CongruenceTest {
  std::vector<std::string> ids;     ///< of the numbers
  std::vector<double> differences;  ///< later minus earlier, mm
  std::vector<double> us;           ///< standard uncertainties of `differences`, mm
  double statistic = 0;             ///< T
  double degreesOfFreedom = 0;      ///< f; may be infinite
  double chance = 1;                ///< probability of this T or a larger one if nothing has changed
};

struct Congruence {
  std::size_t first = 0, second = 0;  ///< indices of the epochs as given
  /// The difference of Δd, measured: later minus earlier, mm, with its u and U. Effects that both epochs
  /// share cancel (`sharedVariance`).
  double difference = 0, u = 0, expanded = 0;
  double chance = 1;                          ///< probability of |difference| or more if Δd has not changed
  bool hasChanged = false;                    ///< |difference| > U
  std::optional<CongruenceTest> device = {};  ///< (O1 − O2)/2 along x and y, and the radii
  std::optional<CongruenceTest> setUp = {};   ///< O1, O2 and the radii
};

/// The variance common to both values of Δd, which cancels in the difference: guideway effects in sessions of
/// one device, instrument effects in sessions of one instrument. Devices and instruments are the same if
/// their serial numbers are equal; without a serial number nothing is shared, which overestimates U.
double sharedVariance(const Epoch& one, const Epoch& other);

bool haveOneInstrument(const Epoch& one, const Epoch& other);
bool haveOneDevice(const Epoch& one, const Epoch& other);

Congruence congruenceOf(const std::vector<Epoch>& epochs, std::size_t first, std::size_t second);

}  // namespace alidade
