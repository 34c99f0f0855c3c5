#pragma once

#include <optional>

#include "ui/jobs/gap.h"
#include "ui/panels/parts/scroll_page.h"

class QCheckBox;
class QGridLayout;
class QLabel;

namespace alidade::ui {

/// The result at a glance: Δd ± U and the verdict, then both arcs and, on request, the published method's
/// figures. Says what is missing where there is no result. All figures can be selected and copied.
class ResultPanel : public ScrollPage {
  Q_OBJECT

 public:
  explicit ResultPanel(QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);
  /// The same evaluation, searched: the published method may have come with it.
  void setSearched(const Evaluation& evaluation);
  void setComparisonShown(bool shown);
  /// What the diagnosis of the evaluation found: only now is the verdict final. Says with a link where model
  /// and readings disagree.
  void setGap(const Gap& gap);
  /// The session has changed: what is said is said as of before.
  void setGapStale();
  /// Another session: nothing is known of it yet.
  void clearGap();

 signals:
  void gapActivated();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showHeadline(const Evaluation& evaluation);
  void showVerdict(const Evaluation& evaluation);
  void showVerdict(const QString& word, const QString& sentence, std::optional<Verdict> verdict);
  void showMeasured(const Gap& gap);
  void showArcs(const SessionFit& fit);
  void showComparison(const Evaluation& evaluation);
  void colorVerdict();
  void settleWidth();
  static QString whatIsMissing(const Evaluation& evaluation);

  std::optional<Verdict> m_verdict;
  QString m_iconName, m_gapHeadline;
  QLabel* m_value;
  QLabel* m_valueNote;
  QLabel* m_unseen;    ///< what may move Δd by more than U unseen
  QLabel* m_measured;  ///< Δd as it was measured, beside that of the fit alone
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
