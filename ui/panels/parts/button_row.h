#pragma once

#include <QWidget>

class QHBoxLayout;
class QPushButton;

namespace alidade::ui {

/// The buttons below the contents of a dialog that stays open: Return presses none of them by itself.
class ButtonRow : public QWidget {
 public:
  ButtonRow();

  /// `name` is that of the object.
  QPushButton* add(const QString& text, const char* name);
  /// Room, as much as there is, before what follows.
  void addRoom();

 private:
  QHBoxLayout* m_layout;
};

}  // namespace alidade::ui
