#pragma once

#include <QObject>

namespace alidade::ui {

/// Reports the signals SIGTERM, SIGINT and SIGHUP in the event loop. A second equal signal ends the process
/// at once. Signals ignored at the start, as by nohup, stay ignored. Only one instance may exist at a time.
class Termination : public QObject {
  Q_OBJECT

 public:
  explicit Termination(QObject* parent = nullptr);
  ~Termination() override;

  /// The first signal; 0: none.
  int signal() const { return m_signal; }

 signals:
  void requested();

 private:
  void take();

  int m_signal = 0;
};

/// Ends the process as by an uncaught signal.
[[noreturn]] void endBySignal(int signal);

}  // namespace alidade::ui
