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

namespace alidade::ui {

/// Runs one piece of work at a time on its own thread; the value arrives in the owner's thread. The
/// destructor requests a stop, waits for the work, and delivers nothing more.
template <typename Value>
class Background {
 public:
  using Shared = std::shared_ptr<const Value>;

  /// `take` receives the value of every piece of work when it is done, stopped or not.
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

  /// Starts the work. Call only while no work is running. `work` makes a `Value` from a `std::stop_token`. At
  /// delivery this object keeps no reference to the value or the work. If `work` throws, `instead` makes the
  /// value in the owner's thread from the reason (`thrownReason`).
  template <typename Work, typename Instead>
  void start(Work work, Instead instead) {
    Q_ASSERT(!m_isAtWork);
    m_stop = std::stop_source();
    m_instead = std::move(instead);
    m_outcome = std::make_shared<Outcome>();
    m_watcher.setFuture(QtConcurrent::run(&m_threads, [work = std::optional(std::move(work)),
                                                       stop = m_stop.get_token(),
                                                       outcome = m_outcome]() mutable {
      outcome->failure = failureOf([&] { outcome->value = std::make_shared<const Value>((*work)(stop)); });
      work.reset();
    }));
    m_isAtWork = true;
  }
  void stop() { m_stop.request_stop(); }
  bool isAtWork() const { return m_isAtWork; }
  bool isStopped() const { return m_stop.stop_requested(); }  ///< of the last started work

 private:
  struct Outcome {
    Shared value;
    std::optional<std::string> failure;  ///< why there is no value
  };

  Shared result() {
    const auto instead = std::exchange(m_instead, nullptr);
    Outcome outcome = std::move(*std::exchange(m_outcome, nullptr));
    return outcome.failure ? std::make_shared<const Value>(instead(*outcome.failure))
                           : std::move(outcome.value);
  }

  QThreadPool m_threads;
  QFutureWatcher<void> m_watcher;
  std::shared_ptr<Outcome> m_outcome;  ///< outcome of the current work
  std::stop_source m_stop;
  std::function<Value(const std::string& reason)> m_instead;
  bool m_isAtWork = false;
};

}  // namespace alidade::ui
