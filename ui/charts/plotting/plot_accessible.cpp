#include "ui/charts/plotting/plot_accessible.h"

#include "ui/charts/plotting/plot_widget.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {
namespace {

QAccessibleInterface* accessiblePlot(const QString&, QObject* object) {
  auto* plot = qobject_cast<PlotWidget*>(object);
  return plot ? new PlotAccessible(*plot) : nullptr;
}

}  // namespace

PlotAccessible::PlotAccessible(PlotWidget& plot)
    : QAccessibleWidget(&plot, QAccessible::Chart), m_plot(plot) {}

PlotAccessible::~PlotAccessible() {
  for (const auto& [index, id] : m_points) QAccessible::deleteAccessibleInterface(id);
}

void PlotAccessible::install() {
  QAccessible::installFactory(accessiblePlot);  // does nothing if already installed
}

QString PlotAccessible::text(QAccessible::Text which) const {
  return which == QAccessible::Value ? m_plot.currentPoint() : QAccessibleWidget::text(which);
}

int PlotAccessible::childCount() const {
  return QAccessibleWidget::childCount() + static_cast<int>(m_plot.pointCount());
}

QAccessibleInterface* PlotAccessible::child(int index) const {
  const int parts = QAccessibleWidget::childCount();
  return index < parts ? QAccessibleWidget::child(index) : point(static_cast<std::size_t>(index - parts));
}

int PlotAccessible::indexOfChild(const QAccessibleInterface* child) const {
  const auto* point = dynamic_cast<const PointAccessible*>(child);
  return point ? QAccessibleWidget::childCount() + static_cast<int>(point->index())
               : QAccessibleWidget::indexOfChild(child);
}

QAccessibleInterface* PlotAccessible::childAt(int x, int y) const {
  if (const auto index = m_plot.pointAt({x, y})) return point(*index);
  return QAccessibleWidget::childAt(x, y);
}

QAccessibleInterface* PlotAccessible::focusChild() const {
  if (const auto index = m_plot.currentIndex(); index && m_plot.hasFocus()) return point(*index);
  return QAccessibleWidget::focusChild();
}

QAccessibleInterface* PlotAccessible::point(std::size_t index) const {
  if (index >= m_plot.pointCount()) return nullptr;
  const auto known = m_points.find(index);
  if (known != m_points.end()) return QAccessible::accessibleInterface(known->second);
  auto* made = new PointAccessible(m_plot, index);  // Qt's cache owns it
  m_points[index] = QAccessible::registerAccessibleInterface(made);
  return made;
}

bool PointAccessible::isValid() const {
  return m_index < m_plot.pointCount();
}

QAccessibleInterface* PointAccessible::parent() const {
  return QAccessible::queryAccessibleInterface(&m_plot);
}

QString PointAccessible::text(QAccessible::Text which) const {
  if (which != QAccessible::Name || !isValid()) return {};
  return listText(m_plot.pointText(m_index).split(u'\n'));
}

QRect PointAccessible::rect() const {
  return isValid() ? m_plot.pointRect(m_index) : QRect();
}

QAccessible::State PointAccessible::state() const {
  QAccessible::State state;
  if (!isValid()) {
    state.invalid = true;
    return state;
  }
  const bool isCurrent = m_plot.currentIndex() == m_index;
  state.focusable = true;
  state.focused = isCurrent && m_plot.hasFocus();
  state.selectable = true;
  state.selected = isCurrent;
  state.readOnly = true;
  state.offscreen = !m_plot.isVisible() || !m_plot.isPointInSight(m_index);
  return state;
}

}  // namespace alidade::ui
