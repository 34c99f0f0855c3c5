#pragma once

#include <QWidget>

#include "ui/jobs/fit_job.h"
#include "ui/text/headline_state.h"

class QLabel;

namespace alidade::ui {

class ToleranceBar;

/// A display to be read from the tripod, in letters as large as the window allows. It shows the next entry
/// with its expected angles, any doubt about the last reading, and the headline with further lines in small
/// type. Keys other than Escape go to the main window.
class BenchDisplay : public QWidget {
  Q_OBJECT

 public:
  explicit BenchDisplay(QWidget* parent);

  void setEvaluation(const SharedEvaluation& evaluation);
  void setHeadline(const Headline& headline);
  /// The position being read.
  void setPosition(std::size_t position);
  /// The doubt about the last reading; empty if the reading is as expected.
  void setDoubt(const QString& doubt);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  void showHeadline();
  void fitText();

  SharedEvaluation m_evaluation;  ///< null before the first evaluation
  std::size_t m_position = 0;
  QString m_doubt;
  Headline m_headline;
  QLabel *m_place, *m_angles, *m_last, *m_result, *m_verdict, *m_below;
  ToleranceBar* m_bar;
};

}  // namespace alidade::ui
