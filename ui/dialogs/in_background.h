#pragma once

#include <QtConcurrent>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

#include "ui/dialogs/busy.h"

namespace alidade::ui {

/// The result of `work`, called with a `std::stop_token` on another thread while the window stays responsive.
/// Absent: the user stopped `work`; the token reports the stop. `work` must own all its data.
template <typename Value, typename Work>
std::optional<Value> inBackground(Busy& busy, Work work) {
  const auto made = std::make_shared<std::optional<Value>>();
  std::stop_source stop;
  QFuture<void> future = QtConcurrent::run(
      [made, work = std::move(work), token = stop.get_token()] { made->emplace(work(token)); });
  if (!busy.waitFor(future)) {
    stop.request_stop();
    return std::nullopt;
  }
  future.waitForFinished();  // rethrows an exception of the work
  return std::move(*made);
}

}  // namespace alidade::ui
