#pragma once

#include <optional>

#include "core/statement/headline.h"
#include "ui/panels/parts/scroll_page.h"
#include "ui/text/headline_state.h"

class QCheckBox;
class QLabel;
class QToolButton;

namespace alidade::ui {

class HeadlineLines;
class StatementView;
class ToleranceBar;

/// The result at a glance: the headline in large type with its place on the scale of the tolerance,
/// warnings about the verdict, and a fold with the reason of the verdict and Δd, fit only; then both
/// arcs and, on request, the published method. Says what is missing if there is no result. All figures can be
/// selected and copied.
class ResultPanel : public ScrollPage {
  Q_OBJECT

 public:
  explicit ResultPanel(QWidget* parent = nullptr);

  void setHeadline(const Headline& headline);
  /// Shows the arcs, or what is missing for a result.
  void setEvaluation(const Evaluation& evaluation);
  /// The same evaluation after the search for misread readings. Shows its figures by the published method.
  void setSearched(const Evaluation& evaluation);
  /// The session changed: keeps the height of the head until the new diagnosis.
  void setGapStale();
  /// Another session is open, which is not diagnosed yet: no longer keeps the height of the head.
  void clearGap();

 signals:
  void gapActivated();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void layOutHead();
  void showVerdict(const Headline& headline);
  void showDetails(const Headline& headline);
  void colorHeadline();
  void fixWidth();
  static QString whatIsMissing(const Evaluation& evaluation);

  State m_state = State::Quiet;  ///< state of the verdict
  bool m_isProvisional = false;
  QString m_iconName;
  QWidget* m_head;  ///< everything that changes with the diagnosis
  QLabel* m_value;
  QLabel* m_badgeIcon;
  QLabel* m_badge;
  QLabel* m_tolerance;
  ToleranceBar* m_bar;
  QLabel* m_reason;  ///< why there is no verdict, or why it is undecided
  HeadlineLines* m_lines;
  QLabel* m_missing;  ///< what is missing for a result
  QToolButton* m_more;
  QLabel* m_details;
  StatementView* m_arcs;
  QCheckBox* m_compare;
  QWidget* m_comparison;
  StatementView* m_published;
};

}  // namespace alidade::ui
