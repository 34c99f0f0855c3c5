#include "ui/panels/window/page_tabs.h"

#include <utility>

namespace alidade::ui {

void PageTabs::addPage(QWidget* page, const QString& title, Show show, Wanted wanted) {
  if (m_pages.empty()) connect(this, &QTabWidget::currentChanged, this, &PageTabs::feedCurrent);
  m_pages.push_back({std::move(show), std::move(wanted)});
  const int tab = addTab(page, title);
  if (m_pages.back().wanted) setTabVisible(tab, false);
}

void PageTabs::setEvaluation(SharedEvaluation evaluation) {
  m_evaluation = std::move(evaluation);
  for (int tab = 0; tab < count(); ++tab) {
    Page& page = m_pages[static_cast<std::size_t>(tab)];
    page.isStale = true;
    if (page.wanted && isTabVisible(tab) != page.wanted(*m_evaluation))
      setTabVisible(tab, !isTabVisible(tab));
  }
  feedCurrent();
}

void PageTabs::showPage(int index) {
  if (!isTabVisible(index)) return;
  setCurrentIndex(index);
  currentWidget()->setFocus(Qt::OtherFocusReason);
}

void PageTabs::feedCurrent() {
  if (!m_evaluation || currentIndex() < 0) return;
  Page& page = m_pages[static_cast<std::size_t>(currentIndex())];
  if (!std::exchange(page.isStale, false)) return;
  page.show(m_evaluation);
}

}  // namespace alidade::ui
