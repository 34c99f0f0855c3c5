#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/series/history/epoch.h"

namespace alidade {

// The situation: a device was measured at two epochs. Is it still the same? The numbers of both fits are
// vectors x₁ and x₂ with their full covariances, and no reading is in both:
//
//   d = x₂ − x₁, C = C₁ + C₂, T = dᵀ C⁻¹ d, T/m ~ F(m, f)
//
// (Pelzer 1971). O1 and O2 refer to the theodolite; they can be compared only between set-ups in the same
// place. (O1 − O2)/2 and the radii belong to the device.

/// The disagreement between numbers of two epochs.
struct CongruenceTest {
  std::vector<std::string> ids;     ///< of the numbers
  std::vector<double> differences;  ///< later minus earlier, mm
  std::vector<double> us;           ///< their standard uncertainties
  double statistic = 0;             ///< T
  double degreesOfFreedom = 0;      ///< f; may be infinite
  double chance = 1;                ///< probability of such a statistic or a larger one if nothing has
                                    ///< changed
};

struct Congruence {
  std::size_t first = 0, second = 0;  ///< indices of the epochs as given
  /// The difference of Δd, measured: later minus earlier, mm. Effects shared by both cancel
  /// (`sharedVariance`).
  double difference = 0, u = 0, expanded = 0;
  double chance = 1;                          ///< probability of such a difference or a larger one if Δd has
                                              ///< not changed
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
