#pragma once

#include "ui/jobs/evaluation.h"
#include "ui/panels/scroll_page.h"

class QLabel;

namespace alidade::ui {

class FigureGrid;

/// Where the uncertainty comes from: readings, model effects, pointing zeros and distance, for Δd and for
/// each coordinate of the centres.
class BudgetPanel : public ScrollPage {
  Q_OBJECT

 public:
  explicit BudgetPanel(QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);

 private:
  void showIntersection(const SessionFit& fit);
  void showCentres(const SessionFit& fit);

  QLabel* m_intersectionTitle;
  FigureGrid* m_intersection;
  QLabel* m_centresTitle;
  FigureGrid* m_centres;
  QLabel* m_note;
};

}  // namespace alidade::ui
