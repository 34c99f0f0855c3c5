#pragma once

#include <QWidget>

#include "ui/jobs/fit_job.h"
#include "ui/text/headline.h"

class QLabel;

namespace alidade::ui {

/// What one wants to read from the tripod, in letters as large as the window lets them be: the next place
/// with the angles expected there, what was last entered and whether it is as expected, and the headline with
/// Δd, fit only, in small type below. Never takes the keyboard: what is typed into it goes to the window.
class BenchDisplay : public QWidget {
  Q_OBJECT

 public:
  explicit BenchDisplay(QWidget* parent);

  void setEvaluation(const SharedEvaluation& evaluation);
  void setHeadline(const Headline& headline);
  /// The position that is being read.
  void setPosition(std::size_t position);
  /// Of the reading entered last; empty: it is as expected.
  void setDoubt(const QString& doubt);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  void showHeadline();
  void fitText();

  SharedEvaluation m_evaluation;  ///< null before the first
  std::size_t m_position = 0;
  QString m_doubt;
  Headline m_headline;
  QLabel *m_place, *m_angles, *m_last, *m_result, *m_verdict, *m_fitOnly;
};

}  // namespace alidade::ui
