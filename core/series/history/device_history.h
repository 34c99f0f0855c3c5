#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/series/history/congruence.h"
#include "core/series/history/epoch.h"
#include "core/series/history/history.h"

namespace alidade {

/// One quantity of a device over time.
struct QuantityHistory {
  /// "intersection" as found, "intersection_of_fit", a length of `Epoch::lengths`, or of a cause
  /// "effect: parameter" where it was found.
  std::string id;
  std::string unit;
  History history;
};

struct DeviceHistory {
  std::string name = {}, serial = {};
  std::vector<Epoch> epochs = {};                ///< by date, as the values of the first quantity
  std::vector<QuantityHistory> quantities = {};  ///< the intersection first
  std::vector<Congruence> congruences = {};      ///< of `pairsOf`
  bool hasOneInstrument = false;                 ///< by its serial number, all sessions
};

/// Epochs by device (its serial number, else its name), each in the order of their dates; of one date in the
/// order given. Those without a date are left out: they go to `undated`, by their index. So are those that
/// hold the same readings as one before them: they go to `copies`, each with that.
struct DeviceHistories {
  std::vector<DeviceHistory> devices;
  std::vector<std::size_t> undated = {};
  std::vector<std::pair<std::size_t, std::size_t>> copies = {};
};
DeviceHistories deviceHistories(const std::vector<Epoch>& epochs);

/// Which epochs are compared: each with the next, and the first with the last; of some twenty, every two.
std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t epochs);

/// Δd as found of these epochs, which are of one device. What all of them share (`sharedVariance`) is in each
/// `u`, but not in `apart`; what may come and go, drifts and the like, is in `apart` as large as is
/// plausible, and `least` is that of the fit alone.
History intersectionHistory(const std::vector<Epoch>& epochs);

}  // namespace alidade
