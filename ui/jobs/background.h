#pragma once

#include <QFutureWatcher>
#include <QThreadPool>
#include <QtConcurrent>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "core/base/failure.h"
#include "ui/document/disposal.h"

namespace alidade::ui {

/// One piece of work at a time on a thread of its own; its value comes back in the thread of the owner.
/// Destroyed, it asks the work to stop, waits for it, and hands in nothing more.
template <typename Value>
class Background {
 public:
  using Shared = std::shared_ptr<const Value>;

  /// `take` gets the value of all work that was started, stopped or not, once it is done.
  template <typename Take>
  explicit Background(Take take) {
    m_threads.setMaxThreadCount(1);
    QObject::connect(&m_watcher, &QFutureWatcherBase::finished, &m_watcher, [this, take] {
      m_isAtWork = false;
      take(result());
    });
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  ~Background() {
    m_watcher.disconnect();
    stop();
    m_threads.waitForDone();
  }

  /// Only while nothing is at work. `work` returns a `Value` from a `std::stop_token`; when that is handed
  /// in, nobody here holds on to the value or to what the work was made of. Where it throws, the value is
  /// what `instead` makes, in the thread of the owner, of the reason as `thrownReason` has it.
  template <typename Work, typename Instead>
  void start(Work work, Instead instead) {
    Q_ASSERT(!m_isAtWork);
    m_stop = std::stop_source();
    m_instead = std::move(instead);
    m_outcome = std::make_shared<Outcome>();
    m_watcher.setFuture(QtConcurrent::run(
        &m_threads,
        [work = std::optional(std::move(work)), stop = m_stop.get_token(), outcome = m_outcome]() mutable {
          outcome->failure = failureOf([&] { outcome->value = sharedAside<Value>((*work)(stop)); });
          work.reset();
        }));
    m_isAtWork = true;
  }
  void stop() { m_stop.request_stop(); }
  bool isAtWork() const { return m_isAtWork; }
  bool isStopped() const { return m_stop.stop_requested(); }  ///< the work started last

 private:
  struct Outcome {
    Shared value;
    std::optional<std::string> failure;  ///< why there is no value
  };

  Shared result() {
    const auto instead = std::exchange(m_instead, nullptr);
    Outcome outcome = std::move(*std::exchange(m_outcome, nullptr));
    return outcome.failure ? sharedAside<Value>(instead(*outcome.failure)) : std::move(outcome.value);
  }

  QThreadPool m_threads;
  QFutureWatcher<void> m_watcher;
  std::shared_ptr<Outcome> m_outcome;  ///< of the work at hand
  std::stop_source m_stop;
  std::function<Value(const std::string& reason)> m_instead;
  bool m_isAtWork = false;
};

}  // namespace alidade::ui
