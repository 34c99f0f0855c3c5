#include "ui/panels/parts/scroll_page.h"

#include <QVBoxLayout>

namespace alidade::ui {

ScrollPage::ScrollPage(const QString& accessibleName, QWidget* parent) : QScrollArea(parent) {
  setAccessibleName(accessibleName);
  setWidgetResizable(true);
  auto* content = new QWidget;
  m_column = new QVBoxLayout(content);
  m_column->setContentsMargins(10, 8, 10, 8);
  m_column->setSpacing(5);
  setWidget(content);
}

}  // namespace alidade::ui
