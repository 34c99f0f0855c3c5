#include "ui/charts/plotting/plot_widget.h"

#include <QApplication>
#include <QEvent>
#include <QGraphicsView>
#include <QMouseEvent>
#include <QToolTip>
#include <QVBoxLayout>

#include "ui/charts/plotting/plot.h"

namespace alidade::ui {

PlotWidget::PlotWidget(std::unique_ptr<Plot> plot, QWidget* parent)
    : QWidget(parent), m_plot(std::move(plot)), m_view(new QGraphicsView(m_plot->scene(), this)) {
  m_view->setFrameShape(QFrame::NoFrame);
  m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_view->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_view->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_view->setRenderHint(QPainter::Antialiasing);
  m_view->setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
  m_view->setFocusPolicy(Qt::NoFocus);
  m_view->setInteractive(false);
  m_view->viewport()->setMouseTracking(true);
  m_view->viewport()->installEventFilter(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_view);
  setMinimumSize(minimumSizeHint());
  restyle();
}

PlotWidget::~PlotWidget() {
  m_view->viewport()->removeEventFilter(this);  // a view half gone has no viewport to compare with
  delete m_view;
}

void PlotWidget::setEvaluation(const Evaluation& evaluation) {
  m_plot->setEvaluation(evaluation);
  setAccessibleDescription(m_plot->summary());
}

void PlotWidget::setHighlighted(std::size_t position, std::size_t row) {
  m_plot->setHighlighted(SightingRef{position, row});
}

void PlotWidget::clearHighlight() {
  m_plot->setHighlighted({});
}

void PlotWidget::restyle() {
  m_plot->setStyle(screenStyle(palette(), font()));
}

void PlotWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) restyle();
  QWidget::changeEvent(event);
}

bool PlotWidget::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_view->viewport()) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::Resize:
      m_plot->arrange(static_cast<QResizeEvent*>(event)->size());
      break;
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      hover(mouse->position().toPoint(), mouse->globalPosition().toPoint());
      break;
    }
    case QEvent::MouseButtonPress:
      m_pressed = static_cast<QMouseEvent*>(event)->position().toPoint();
      break;
    case QEvent::MouseButtonRelease: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      const QPoint place = mouse->position().toPoint();
      const bool still = (place - m_pressed).manhattanLength() < QApplication::startDragDistance();
      if (mouse->button() == Qt::LeftButton && still) activate(place);
      break;
    }
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void PlotWidget::hover(const QPoint& place, const QPoint& globalPlace) {
  const Mark* mark = m_plot->markAt(m_view->mapToScene(place));
  m_view->viewport()->setCursor(mark ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (mark) {
    QToolTip::showText(globalPlace, m_plot->describe(*mark), m_view->viewport());
  } else {
    QToolTip::hideText();
  }
}

void PlotWidget::activate(const QPoint& place) {
  if (const Mark* mark = m_plot->markAt(m_view->mapToScene(place))) {
    emit sightingActivated(mark->ref.position, mark->ref.row);
  }
}

}  // namespace alidade::ui
