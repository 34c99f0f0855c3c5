#pragma once

#include <QElapsedTimer>
#include <QFuture>
#include <QString>
#include <memory>

class QProgressDialog;
class QWidget;

namespace alidade::ui {

/// An operation the user waits for. During the operation, the window paints and takes no input. After 0.4 s a
/// dialog shows the operation, with a stop button if the user can stop the operation.
class Busy {
 public:
  /// `ToItsEnd`: the user cannot stop the operation, such as writing a file.
  enum class Way { Stoppable, ToItsEnd };

  Busy(QWidget* parent, const QString& doing, Way way = Way::Stoppable);
  ~Busy();
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

  /// Waits for work on another thread. False: the user stopped the wait; the work may still be running.
  bool waitFor(const QFuture<void>& work);
  /// Keeps the window responsive during work on the window's thread; to be called often. `done`: the share of
  /// the work, 0 to 1. False: the user stopped the work.
  bool goesOn(double done);

 private:
  void showDialog();

  QWidget* m_parent;
  QString m_doing;
  Way m_way;
  QElapsedTimer m_since, m_breath;
  std::unique_ptr<QProgressDialog> m_dialog;  ///< null until the operation has taken 0.4 s
};

}  // namespace alidade::ui
