#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/series/history/congruence.h"
#include "core/series/history/epoch.h"
#include "core/series/history/quantity_history.h"

namespace alidade {

struct DeviceHistory {
  std::string name = {}, serial = {};
  std::vector<Epoch> epochs = {};                ///< by date, like the values of the first quantity
  std::vector<QuantityHistory> quantities = {};  ///< the intersection is the first
  std::vector<Congruence> congruences = {};      ///< of the pairs from `pairsOf`
  /// Sessions have vertical circles of both kinds. Sizes of their errors are then those on a zenith circle.
  bool hasBothCircles = false;
  bool hasOneInstrument = false;  ///< all sessions have the same instrument serial number
};

/// Epochs grouped by device (its serial number, else its name), sorted by date and, within a date, in the
/// order given. Epochs without a date are excluded: `undated` holds their indices. Epochs with the same
/// readings as an earlier epoch are excluded as well: `copies` pairs each of them with the earlier one.
struct DeviceHistories {
  std::vector<DeviceHistory> devices;
  std::vector<std::size_t> undated = {};
  std::vector<std::pair<std::size_t, std::size_t>> copies = {};
};
DeviceHistories deviceHistories(const std::vector<Epoch>& epochs);

/// The first `sessions` sessions become the baseline of every quantity's control chart; 0: all sessions.
void setBaseline(DeviceHistory& device, std::size_t sessions);

/// The pairs of epochs to compare: for up to 20 epochs, all pairs; for more, each epoch with the next, and
/// the first with the last.
std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t epochs);

/// Δd, measured, of the epochs, which must belong to one device. Effects shared by all epochs
/// (`sharedVariance`) are in each `u`, but not in `apart`. `apart` includes effects that may vary, such as
/// drifts, at their plausible size; `least` is the uncertainty of the fit only.
History intersectionHistory(const std::vector<Epoch>& epochs);

}  // namespace alidade
