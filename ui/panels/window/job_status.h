#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace alidade::ui {

class FitJob;
class GapJob;

/// Shows work on the session in the status bar if it takes longer than a moment. A button stops the
/// diagnosis and the search for misread readings, but no fit.
class JobStatus : public QWidget {
  Q_OBJECT

 public:
  JobStatus(const FitJob& fit, const GapJob& gap, QWidget* parent = nullptr);

  /// Call when work starts. Polls until all work is done.
  void watch();

 signals:
  void stopWanted();

 private:
  void look();
  QString doing() const;

  const FitJob& m_fit;
  const GapJob& m_gap;
  QTimer m_watch;
  int m_looks = 0;  ///< number of polls since the work began
  QLabel* m_text;
  QToolButton* m_stop;
};

}  // namespace alidade::ui
