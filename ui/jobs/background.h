#pragma once

#include <QFutureWatcher>
#include <QThreadPool>
#include <QtConcurrent>
#include <functional>
#include <memory>
#include <stop_token>
#include <utility>

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
      take(m_watcher.result());
    });
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  ~Background() {
    m_watcher.disconnect();
    stop();
    m_threads.waitForDone();
  }

  /// Only while nothing is at work. `work` returns a `Value` from a `std::stop_token`.
  template <typename Work>
  void start(Work work) {
    Q_ASSERT(!m_isAtWork);
    m_isAtWork = true;
    m_stop = std::stop_source();
    m_watcher.setFuture(
        QtConcurrent::run(&m_threads, [work = std::move(work), stop = m_stop.get_token()]() -> Shared {
          return std::make_shared<const Value>(work(stop));
        }));
  }
  void stop() { m_stop.request_stop(); }
  bool isAtWork() const { return m_isAtWork; }
  bool isStopped() const { return m_stop.stop_requested(); }  ///< the work started last

 private:
  QThreadPool m_threads;
  QFutureWatcher<Shared> m_watcher;
  std::stop_source m_stop;
  bool m_isAtWork = false;
};

}  // namespace alidade::ui
