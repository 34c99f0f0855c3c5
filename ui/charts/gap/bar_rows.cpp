#include "ui/charts/gap/bar_rows.h"

#include <QHelpEvent>
#include <QToolTip>

namespace alidade::ui {

BarRows::BarRows(const QString& accessibleName, QWidget* parent) : QWidget(parent) {
  setAccessibleName(accessibleName);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void BarRows::changeTo(const QString& spoken) {
  setAccessibleDescription(spoken);
  updateGeometry();
  update();
}

bool BarRows::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString about = aboutAt(help->pos());
  if (about.isEmpty())
    QToolTip::hideText();
  else
    QToolTip::showText(help->globalPos(), about, this);
  return true;
}

}  // namespace alidade::ui
