#pragma once

#include <QObject>

namespace alidade::ui {

/// Tells in the event loop that the process is asked to end: by SIGTERM, SIGINT or SIGHUP. The same signal
/// again ends the process at once. A signal that was ignored at the start, as by nohup, stays ignored. One at
/// a time.
class Termination : public QObject {
  Q_OBJECT

 public:
  explicit Termination(QObject* parent = nullptr);
  ~Termination() override;

  /// The first signal; 0: none came.
  int signal() const { return m_signal; }

 signals:
  void asked();

 private:
  void take();

  int m_signal = 0;
};

/// Ends the process as if nobody had caught the signal.
[[noreturn]] void endBySignal(int signal);

}  // namespace alidade::ui
