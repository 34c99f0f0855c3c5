#pragma once

#include <QScrollArea>

class QVBoxLayout;

namespace alidade::ui {

/// A page of figures as wide as its tab, which scrolls vertically if the tab is too low.
class ScrollPage : public QScrollArea {
  Q_OBJECT

 public:
  explicit ScrollPage(const QString& accessibleName, QWidget* parent = nullptr);

 protected:
  QVBoxLayout* column() const { return m_column; }

 private:
  QVBoxLayout* m_column;
};

}  // namespace alidade::ui
