#include "ui/charts/plotting/plot_widget.h"

#include <QAccessible>
#include <QApplication>
#include <QEvent>
#include <QGraphicsView>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QRubberBand>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <cmath>
#include <limits>

#include "ui/charts/plotting/caption.h"
#include "ui/charts/plotting/plot.h"
#include "ui/charts/plotting/plot_accessible.h"

namespace alidade::ui {
namespace {

constexpr double zoomStep = 1.25, moveStep = 0.1;  // factor per wheel notch; share of the plot area

}  // namespace

PlotWidget::PlotWidget(std::unique_ptr<Plot> plot, QWidget* parent)
    : QWidget(parent),
      m_plot(std::move(plot)),
      m_view(new QGraphicsView(m_plot->scene(), this)),
      m_caption(new Caption),
      m_menuButton(new QToolButton(this)),
      m_files(new ChartFiles(*this, this)),
      m_band(new QRubberBand(QRubberBand::Rectangle, m_view->viewport())) {
  PlotAccessible::install();
  m_view->setFrameShape(QFrame::NoFrame);
  m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_view->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_view->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_view->setRenderHint(QPainter::Antialiasing);
  m_view->setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
  m_view->setFocusPolicy(Qt::NoFocus);
  m_view->setInteractive(false);
  m_view->viewport()->setFocusPolicy(Qt::NoFocus);
  m_view->viewport()->setMouseTracking(true);
  m_view->viewport()->installEventFilter(this);
  m_menuButton->setAutoRaise(true);
  m_menuButton->setArrowType(Qt::DownArrow);
  m_menuButton->setFocusPolicy(Qt::NoFocus);
  m_menuButton->setFixedSize(20, 20);
  m_menuButton->setAccessibleName(tr("Menu of the chart"));
  m_menuButton->setToolTip(tr("Copy or save the chart, enlarge it, choose what is drawn (right click)"));
  connect(m_menuButton, &QToolButton::clicked, this,
          [this] { showMenu(m_menuButton->mapToGlobal(QPoint(0, m_menuButton->height()))); });
  setFocusPolicy(Qt::StrongFocus);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(1, 1, 1, 1);
  layout->setSpacing(0);
  layout->addWidget(m_view, 1);
  layout->addWidget(m_caption);
  setMinimumSize(minimumSizeHint());
  m_plot->setCorner(m_menuButton->width());
  restyle();
}

PlotWidget::~PlotWidget() {
  m_view->viewport()->removeEventFilter(this);  // a partly destroyed view has no viewport to compare with
  delete m_view;
}

void PlotWidget::setEvaluation(const Evaluation& evaluation) {
  m_plot->setEvaluation(evaluation);
  updateDescriptions();
}

void PlotWidget::updateDescriptions() {
  m_caption->setSentence(m_plot->message().isEmpty() ? m_plot->standard() : QString());
  setAccessibleDescription(m_plot->summary());
}

void PlotWidget::setHighlighted(std::size_t position, std::size_t row) {
  const SightingRef ref{position, row};
  if (const Mark* mark = m_plot->current(); mark && mark->ref != ref) m_plot->clearCurrent();
  m_plot->setHighlighted(ref);
}

void PlotWidget::clearHighlight() {
  m_plot->setHighlighted({});
}

void PlotWidget::showWhole() {
  m_plot->showWhole();
}

QString PlotWidget::currentPoint() const {
  const Mark* mark = m_plot->current();
  return mark ? m_plot->describe(*mark) : QString();
}

std::size_t PlotWidget::pointCount() const {
  return m_plot->markers().marks().size();
}

std::optional<std::size_t> PlotWidget::currentIndex() const {
  return m_plot->markers().current();
}

std::optional<std::size_t> PlotWidget::pointAt(const QPoint& onScreen) const {
  const QPoint at = m_view->viewport()->mapFromGlobal(onScreen);
  const Mark* mark = m_plot->markAt(m_view->mapToScene(at));
  if (!mark) return {};
  return static_cast<std::size_t>(mark - m_plot->markers().marks().data());
}

QString PlotWidget::pointText(std::size_t point) const {
  return m_plot->describe(m_plot->markers().marks().at(point));
}

QRect PlotWidget::pointRect(std::size_t point) const {
  constexpr int reach = 6;  // pixels around the middle
  const QPointF scene = m_plot->markers().scenePosition(m_plot->markers().marks().at(point));
  const QPoint at = m_view->viewport()->mapToGlobal(m_view->mapFromScene(scene));
  return {at - QPoint(reach, reach), QSize(2 * reach, 2 * reach)};
}

bool PlotWidget::isPointInSight(std::size_t point) const {
  const Mark& mark = m_plot->markers().marks().at(point);
  return m_plot->plotArea().contains(m_plot->markers().scenePosition(mark));
}

PaintedPicture PlotWidget::picture() {
  return {m_view->viewport()->size(), accessibleName(), m_plot->summary(),
          [this](QPainter* painter) { m_plot->paint(painter); }};
}

std::string PlotWidget::numbers() const {
  return m_plot->csv();
}

void PlotWidget::restyle() {
  m_plot->setStyle(screenStyle(palette(), font()));
}

void PlotWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) restyle();
  QWidget::changeEvent(event);
}

/// Handles Ctrl+C as a key of the plot; otherwise it would be a shortcut of the window.
bool PlotWidget::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

bool PlotWidget::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_view->viewport()) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::Resize:
      m_plot->arrange(static_cast<QResizeEvent*>(event)->size());
      break;
    case QEvent::ToolTip:
      return true;  // the scene has no tool tips of marks and hides the tool tip shown
    case QEvent::MouseMove:
      drag(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::MouseButtonPress:
      press(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::MouseButtonRelease:
      release(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::MouseButtonDblClick:
      endDrag();
      if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) m_plot->showWhole();
      break;
    case QEvent::Wheel: {
      const auto* wheel = static_cast<QWheelEvent*>(event);
      const double notches = wheel->angleDelta().y() / 120.0;
      m_plot->zoom(std::pow(zoomStep, notches), m_view->mapToScene(wheel->position().toPoint()));
      return true;
    }
    case QEvent::ContextMenu:
      showMenu(static_cast<QContextMenuEvent*>(event)->globalPos());
      return true;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void PlotWidget::press(const QMouseEvent& mouse) {
  endDrag();
  const bool isLeft = mouse.button() == Qt::LeftButton;
  if (!isLeft && mouse.button() != Qt::MiddleButton) return;
  setFocus(Qt::MouseFocusReason);
  m_pressed = m_dragged = mouse.position().toPoint();
  m_drag = isLeft && !(mouse.modifiers() & Qt::ShiftModifier) ? Drag::Press : Drag::Move;
  if (m_drag == Drag::Move) m_view->viewport()->setCursor(Qt::ClosedHandCursor);
}

void PlotWidget::drag(const QMouseEvent& mouse) {
  const QPoint place = mouse.position().toPoint();
  if (m_drag == Drag::None) return hover(place, mouse.globalPosition().toPoint());
  if (m_drag == Drag::Move) {
    m_plot->move(place - m_dragged);
    m_dragged = place;
    return;
  }
  if ((place - m_pressed).manhattanLength() >= QApplication::startDragDistance()) m_drag = Drag::Band;
  if (m_drag != Drag::Band) return;
  m_band->setGeometry(QRect(m_pressed, place).normalized() & m_plot->plotArea().toRect());
  m_band->show();
}

void PlotWidget::release(const QMouseEvent& mouse) {
  const QPoint place = mouse.position().toPoint();
  const Drag ended = m_drag;
  endDrag();
  if (ended == Drag::Press) activate(place);
  // Ignores a drag of only a few pixels in width or height as unintended.
  const QRect part = QRect(m_pressed, place).normalized();
  constexpr int least = 4;
  if (ended == Drag::Band && part.width() > least && part.height() > least) m_plot->zoomTo(part);
}

void PlotWidget::endDrag() {
  m_drag = Drag::None;
  m_band->hide();
  m_view->viewport()->setCursor(Qt::ArrowCursor);
}

void PlotWidget::hover(const QPoint& place, const QPoint& globalPlace) {
  const QPointF scene = m_view->mapToScene(place);
  const Mark* mark = m_plot->markAt(scene);
  m_view->viewport()->setCursor(mark ? Qt::PointingHandCursor : Qt::ArrowCursor);
  const QString tip = mark ? m_plot->describe(*mark) : m_plot->tipAt(scene);
  if (tip.isEmpty()) return QToolTip::hideText();
  constexpr int untilTheMouseMoves = std::numeric_limits<int>::max();
  QToolTip::showText(globalPlace, tip, m_view->viewport(), {}, untilTheMouseMoves);
}

void PlotWidget::activate(const QPoint& place) {
  if (const Mark* mark = m_plot->markAt(m_view->mapToScene(place))) {
    emit sightingActivated(mark->ref.position, mark->ref.row);
  }
}

void PlotWidget::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const bool isShifted = event->modifiers() & Qt::ShiftModifier;
  if (event->matches(QKeySequence::Copy)) return m_files->copy();
  if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
    return QWidget::keyPressEvent(event);
  if (isShifted ? movedBy(key) : steppedBy(key)) return;
  const Mark* mark = m_plot->current();
  switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoomAtCurrent(zoomStep);
    case Qt::Key_Minus:
      return zoomAtCurrent(1 / zoomStep);
    case Qt::Key_Home:
      return m_plot->showWhole();
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      if (!mark) break;
      emit sightingActivated(mark->ref.position, mark->ref.row);
      return;
    case Qt::Key_Escape:
      if (!mark) break;
      m_plot->clearCurrent();
      QToolTip::hideText();
      return;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

void PlotWidget::zoomAtCurrent(double factor) {
  const Mark* mark = m_plot->current();
  const QPointF at = mark ? m_plot->markers().scenePosition(*mark) : m_plot->plotArea().center();
  m_plot->zoom(factor, at);
}

bool PlotWidget::movedBy(int key) {
  const QSizeF area = m_plot->plotArea().size() * moveStep;
  switch (key) {
    case Qt::Key_Left:
      m_plot->move({area.width(), 0});
      return true;
    case Qt::Key_Right:
      m_plot->move({-area.width(), 0});
      return true;
    case Qt::Key_Up:
      m_plot->move({0, area.height()});
      return true;
    case Qt::Key_Down:
      m_plot->move({0, -area.height()});
      return true;
    default:
      return false;
  }
}

bool PlotWidget::steppedBy(int key) {
  const Mark* mark = nullptr;
  if (key == Qt::Key_Left) mark = m_plot->step(Plot::Step::Left);
  if (key == Qt::Key_Right) mark = m_plot->step(Plot::Step::Right);
  if (key == Qt::Key_Down) mark = m_plot->step(Plot::Step::Down);
  if (key == Qt::Key_Up) mark = m_plot->step(Plot::Step::Up);
  if (!mark) return false;
  const QPoint at = m_view->mapFromScene(m_plot->markers().scenePosition(*mark));
  QToolTip::showText(m_view->viewport()->mapToGlobal(at + QPoint(8, 8)), m_plot->describe(*mark),
                     m_view->viewport());
  const SightingRef ref = mark->ref;
  QAccessibleValueChangeEvent announcement(this, currentPoint());
  QAccessible::updateAccessibility(&announcement);
  announceFocus();
  emit sightingStepped(ref.position, ref.row);
  return true;
}

/// Makes a screen reader read the current point instead of the plot as a whole.
void PlotWidget::announceFocus() {
  if (!QAccessible::isActive()) return;
  QAccessibleInterface* plot = QAccessible::queryAccessibleInterface(this);
  QAccessibleInterface* point = plot ? plot->focusChild() : nullptr;
  if (!point) return;
  QAccessibleEvent focus(point, QAccessible::Focus);
  QAccessible::updateAccessibility(&focus);
}

void PlotWidget::contextMenuEvent(QContextMenuEvent* event) {
  showMenu(event->reason() == QContextMenuEvent::Mouse ? event->globalPos() : mapToGlobal(rect().center()));
}

void PlotWidget::showMenu(const QPoint& globalPlace) {
  endDrag();
  m_menu = makeMenu();
  m_menu->popup(globalPlace);
}

std::unique_ptr<QMenu> PlotWidget::makeMenu() {
  auto menu = std::make_unique<QMenu>(this);
  m_files->addTo(*menu);
  menu->addSeparator();
  menu->addAction(tr("Zoom &In\t+"), this, [this] { zoomAtCurrent(zoomStep); });
  menu->addAction(tr("Zoom &Out\t−"), this, [this] { zoomAtCurrent(1 / zoomStep); })
      ->setEnabled(m_plot->isZoomed());
  menu->addAction(tr("Show &Whole\tHome"), this, [this] { m_plot->showWhole(); })
      ->setEnabled(m_plot->isZoomed());
  addChoices(*menu);
  return menu;
}

void PlotWidget::addChoices(QMenu&) {}

void PlotWidget::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void PlotWidget::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  QToolTip::hideText();
  update();
}

void PlotWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  constexpr int linesToSpare = 14;  // lines of text, including the plot
  m_caption->setMaySpread(height() >= linesToSpare * fontMetrics().height());
  m_menuButton->move(width() - m_menuButton->width() - 2, 2);
  m_menuButton->raise();
}

/// Paints a frame that shows the keyboard focus.
void PlotWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Base));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace alidade::ui
