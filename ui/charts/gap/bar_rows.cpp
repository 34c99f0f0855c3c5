#include "ui/charts/gap/bar_rows.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QToolTip>

namespace alidade::ui {

BarRows::BarRows(const QString& accessibleName, const QString& fileName, QWidget* parent)
    : QWidget(parent), m_fileName(fileName), m_files(new ChartFiles(*this, this)) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(accessibleName);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void BarRows::changeTo(const QString& accessible) {
  setAccessibleDescription(accessible);
  updateGeometry();
  update();
}

PaintedPicture BarRows::picture() {
  return {size(), accessibleName(), accessibleDescription(), [this](QPainter* painter) {
            painter->fillRect(rect(), palette().color(QPalette::Window));
            render(painter, {}, {}, QWidget::RenderFlags());
          }};
}

void BarRows::contextMenuEvent(QContextMenuEvent* event) {
  m_menu = std::make_unique<QMenu>(this);
  m_files->addTo(*m_menu);
  m_menu->popup(event->globalPos());
}

void BarRows::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy))
    m_files->copy();
  else
    QWidget::keyPressEvent(event);
}

bool BarRows::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
    event->accept();
    return true;
  }
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
