#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace alidade::ui {

class FitJob;
class GapJob;

/// Says in the status bar what is at work on the session where it takes longer than a moment, with a button
/// that stops what is not the fit itself: a fit ends with the next edit.
class JobStatus : public QWidget {
  Q_OBJECT

 public:
  JobStatus(const FitJob& fit, const GapJob& gap, QWidget* parent = nullptr);

  /// Something was asked for: looks on until all is done.
  void watch();

 signals:
  void stopWanted();

 private:
  void look();
  QString doing() const;

  const FitJob& m_fit;
  const GapJob& m_gap;
  QTimer m_watch;
  int m_looks = 0;  ///< since there was nothing to do
  QLabel* m_text;
  QToolButton* m_stop;
};

}  // namespace alidade::ui
