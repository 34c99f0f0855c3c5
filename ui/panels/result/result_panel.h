#pragma once

#include <optional>

#include "core/evaluation/gap.h"
#include "ui/panels/parts/scroll_page.h"
#include "ui/text/headline.h"

class QCheckBox;
class QGridLayout;
class QLabel;

namespace alidade::ui {

/// The result at a glance: the headline in large type, Δd, fit only, below it in small type, then both arcs
/// and, on request, the published method. Says what is missing if there is no result. All figures can be
/// selected and copied.
class ResultPanel : public ScrollPage {
  Q_OBJECT

 public:
  explicit ResultPanel(QWidget* parent = nullptr);

  void setHeadline(const Headline& headline);
  /// Shows the arcs, or what is missing for a result.
  void setEvaluation(const Evaluation& evaluation);
  /// The same evaluation after the search; it may add the published method.
  void setSearched(const Evaluation& evaluation);
  void setComparisonShown(bool shown);
  /// Shows undetectable effects, and a link if model and readings disagree.
  void setGap(const Gap& gap);
  /// The session changed: the contents are marked as outdated.
  void setGapStale();
  /// Another session, not diagnosed yet.
  void clearGap();

 signals:
  void gapActivated();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void layOutHead();
  void showVerdict(const VerdictText& verdict);
  void showFitOnly(const Headline& headline);
  void showArcs(const SessionFit& fit);
  void showComparison(const Evaluation& evaluation);
  void colorHeadline();
  void settleWidth();
  static QString whatIsMissing(const Evaluation& evaluation);

  State m_state = State::Quiet;  ///< state of the verdict
  bool m_isProvisional = false;
  QString m_iconName, m_gapHeadline;
  QWidget* m_head;  ///< everything that changes with the diagnosis
  QLabel* m_name;
  QLabel* m_value;
  QLabel* m_tolerance;
  QLabel* m_fitOnly;
  QLabel* m_missing;       ///< what is missing for a result
  QLabel* m_undetectable;  ///< undetectable effects that may move Δd by more than U
  QLabel* m_badgeIcon;
  QLabel* m_badge;
  QLabel* m_sentence;
  QLabel* m_gapHint;
  class FigureGrid* m_arcs;
  QCheckBox* m_compare;
  QWidget* m_comparison;
  class FigureGrid* m_published;
};

}  // namespace alidade::ui
