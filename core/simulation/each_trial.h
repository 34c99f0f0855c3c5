#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/threads.h"

namespace alidade {

/// Makes the trials 0 … `count` − 1 in `threads` threads; 0: as many as the machine has. The result does not
/// depend on their number. `progress` gets the number of trials done. If trials fail, returns the problem of
/// the first of them; no further trial is then begun.
template <typename Trial>
Result<std::vector<Trial>> eachTrial(std::size_t count, std::size_t threads,
                                     const std::function<Result<Trial>(std::size_t)>& make,
                                     const std::function<void(std::size_t)>& progress = {}) {
  std::vector<std::optional<Result<Trial>>> results(count);
  std::atomic<bool> failed = false;
  std::mutex reporting;
  std::size_t done = 0;
  doEach(threadsOrAll(threads), count, [&](std::size_t i) {
    if (failed) return;
    results[i] = make(i);
    if (!*results[i]) failed = true;
    if (!progress) return;
    const std::scoped_lock lock(reporting);
    progress(++done);
  });
  std::vector<Trial> trials;
  for (auto& result : results) {
    if (result && !*result) return result->problem();
    if (result) trials.push_back(**std::move(result));
  }
  return trials;
}

}  // namespace alidade
