#pragma once

#include <QElapsedTimer>
#include <QFuture>
#include <QString>
#include <memory>

class QProgressDialog;
class QWidget;

namespace alidade::ui {

/// What the user waits for. While it lasts the window paints and takes no input; where it takes longer than a
/// moment, a dialog says what is done, with a button that stops it where it can be stopped.
class Busy {
 public:
  /// A file that is being written is not left half way.
  enum class Way { Stoppable, ToItsEnd };

  Busy(QWidget* parent, const QString& doing, Way way = Way::Stoppable);
  ~Busy();
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

  /// Waits for work on another thread. False: the user stopped it, where it can be; it may still be at work.
  bool waitFor(const QFuture<void>& work);
  /// For work on the window's own thread, asked often: lets the window live now and then. `done`: the share
  /// of the work, 0 to 1. False: the user stopped it.
  bool goesOn(double done);

 private:
  void showDialog();

  QWidget* m_parent;
  QString m_doing;
  Way m_way;
  QElapsedTimer m_since, m_breath;
  std::unique_ptr<QProgressDialog> m_dialog;  ///< null until it takes longer than a moment
};

}  // namespace alidade::ui
