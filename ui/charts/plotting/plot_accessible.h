#pragma once

#include <QAccessibleWidget>
#include <cstddef>
#include <unordered_map>

namespace alidade::ui {

class PlotWidget;

/// The accessible interface of a plot: name and summary as for any widget, the current point as its value,
/// and every point as a child after the parts of the widget.
class PlotAccessible : public QAccessibleWidget {
 public:
  explicit PlotAccessible(PlotWidget& plot);
  ~PlotAccessible() override;

  /// Installs the interface for all plots created from now on.
  static void install();

  QString text(QAccessible::Text which) const override;
  int childCount() const override;
  QAccessibleInterface* child(int index) const override;
  int indexOfChild(const QAccessibleInterface* child) const override;
  QAccessibleInterface* childAt(int x, int y) const override;
  QAccessibleInterface* focusChild() const override;

 private:
  QAccessibleInterface* point(std::size_t index) const;

  PlotWidget& m_plot;
  mutable std::unordered_map<std::size_t, QAccessible::Id> m_points;  ///< created on request
};

/// A point of a plot: its text, its place on the screen, and whether it has the focus. Identified by its
/// number, which after an edit may refer to another point or none.
class PointAccessible : public QAccessibleInterface {
 public:
  PointAccessible(PlotWidget& plot, std::size_t index) : m_plot(plot), m_index(index) {}

  std::size_t index() const { return m_index; }

  bool isValid() const override;
  QObject* object() const override { return nullptr; }
  QAccessibleInterface* parent() const override;
  QAccessibleInterface* child(int) const override { return nullptr; }
  QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  int childCount() const override { return 0; }
  int indexOfChild(const QAccessibleInterface*) const override { return -1; }
  QString text(QAccessible::Text which) const override;
  void setText(QAccessible::Text, const QString&) override {}
  QRect rect() const override;
  QAccessible::Role role() const override { return QAccessible::ListItem; }
  QAccessible::State state() const override;

 private:
  PlotWidget& m_plot;
  std::size_t m_index;
};

}  // namespace alidade::ui
