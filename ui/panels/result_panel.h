#pragma once

#include <QScrollArea>
#include <vector>

#include "ui/jobs/evaluation.h"

class QCheckBox;
class QGridLayout;
class QLabel;

namespace alidade::ui {

/// The result at a glance: Δd ± U and the verdict, then both arcs, the budget and, on request, the published
/// method's figures. Says what is missing where there is no result. All figures can be selected and copied.
class ResultPanel : public QScrollArea {
  Q_OBJECT

 public:
  explicit ResultPanel(QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);
  void setComparisonShown(bool shown);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showHeadline();
  void showVerdict();
  void showArcs();
  void showBudget();
  void showEffects();
  void showComparison();
  void colorVerdict();
  void settleWidth();
  QString whatIsMissing() const;

  Evaluation m_evaluation;
  QString m_iconName;
  QLabel* m_value;
  QLabel* m_valueNote;
  QLabel* m_badgeIcon;
  QLabel* m_badge;
  QLabel* m_sentence;
  QLabel* m_budgetTitle;
  class FigureGrid* m_arcs;
  class FigureGrid* m_budget;
  QLabel* m_effectsTitle;
  class FigureGrid* m_effects;
  QCheckBox* m_compare;
  QWidget* m_comparison;
  class FigureGrid* m_published;
};

}  // namespace alidade::ui
