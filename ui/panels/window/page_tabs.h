#pragma once

#include <QTabWidget>
#include <functional>
#include <vector>

#include "ui/jobs/fit_job.h"

namespace alidade::ui {

/// Pages of an evaluation. Only the page in front is updated: a hidden page costs no time per edit, and is
/// updated when it comes to the front.
class PageTabs : public QTabWidget {
  Q_OBJECT

 public:
  using Show = std::function<void(const SharedEvaluation&)>;
  using Wanted = std::function<bool(const Evaluation&)>;

  using QTabWidget::QTabWidget;

  /// Adds a page, which is shown if `wanted` is empty or returns true.
  void addPage(QWidget* page, const QString& title, Show show, Wanted wanted = {});

  void setEvaluation(SharedEvaluation evaluation);
  /// Brings the page to the front and gives it the keyboard; does nothing if the page is hidden.
  void showPage(int index);

 private:
  struct Page {
    Show show;
    Wanted wanted;
    bool isStale = true;
  };

  void feedCurrent();

  std::vector<Page> m_pages;  ///< in the order of the tabs
  SharedEvaluation m_evaluation;
};

/// A `Show` that passes the evaluation to the page's `setEvaluation`.
template <typename Panel>
PageTabs::Show showIn(Panel* panel) {
  return [panel](const SharedEvaluation& evaluation) {
    if constexpr (requires { panel->setEvaluation(evaluation); })
      panel->setEvaluation(evaluation);
    else
      panel->setEvaluation(*evaluation);
  };
}

}  // namespace alidade::ui
