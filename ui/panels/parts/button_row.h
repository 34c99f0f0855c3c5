#pragma once

#include <QWidget>

class QHBoxLayout;
class QPushButton;

namespace alidade::ui {

/// The buttons below a dialog that stays open: Return presses none of them by default.
class ButtonRow : public QWidget {
 public:
  ButtonRow();

  /// `name` is the object name.
  QPushButton* add(const QString& text, const char* name);
  /// Adds stretch before the following buttons.
  void addRoom();

 private:
  QHBoxLayout* m_layout;
};

}  // namespace alidade::ui
