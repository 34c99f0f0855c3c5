#pragma once

#include <QtConcurrent>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

#include "ui/dialogs/busy.h"

namespace alidade::ui {

/// What `work` makes of a `std::stop_token`, on another thread, while the window stays alive. Absent: the
/// user stopped it; the work is told, and what it still makes is dropped. It must hold all it needs.
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
  future.waitForFinished();  // hands on what was thrown
  return std::move(*made);
}

}  // namespace alidade::ui
