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
//   d = x₂ − x₁,  C = C₁ + C₂,  T = dᵀ C⁻¹ d,  T/m as F(m, f)
//
// (Pelzer 1971). O1 and O2 are told from where the theodolite stood; they agree only where it stood in the
// same place. (O1 − O2)/2 and the radii are the device's own.

/// How far numbers of two epochs disagree.
struct CongruenceTest {
  std::vector<std::string> ids;     ///< of the numbers
  std::vector<double> differences;  ///< the later less the earlier, mm
  std::vector<double> us;           ///< their standard uncertainties
  double statistic = 0;             ///< T
  double degreesOfFreedom = 0;      ///< f; may be infinite
  double chance = 1;                ///< of so much or more where nothing has changed
};

struct Congruence {
  std::size_t first = 0, second = 0;  ///< epochs, as they were given
  /// Of Δd as found: the later less the earlier, mm. What both share cancels (`sharedVariance`).
  double difference = 0, u = 0, expanded = 0;
  double chance = 1;                          ///< of so much or more where Δd has not changed
  bool hasChanged = false;                    ///< |difference| > U
  std::optional<CongruenceTest> device = {};  ///< (O1 − O2)/2 along x and y, and the radii
  std::optional<CongruenceTest> setUp = {};   ///< O1, O2 and the radii
};

/// The part of the variance of each Δd that both sessions have alike, so that it cancels in the difference:
/// the effects of the guideway in sessions of one device, those of the instrument in sessions of one
/// instrument. Devices and instruments are the same where both have the same serial number; where one has
/// none nothing is taken for shared, which makes U larger than it is.
double sharedVariance(const Epoch& one, const Epoch& other);

bool haveOneInstrument(const Epoch& one, const Epoch& other);
bool haveOneDevice(const Epoch& one, const Epoch& other);

Congruence congruenceOf(const std::vector<Epoch>& epochs, std::size_t first, std::size_t second);

}  // namespace alidade
