#pragma once

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
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

/// Focuses the non-destructive button and makes it the default, so that Return presses it even when another
/// widget has the focus. Call once all buttons of the dialog exist.
void makeSafeButton(QPushButton& button);

/// A wrapping label that shows its text without interpreting markup.
QLabel* createPlainLabel(const QString& text);

/// A list of the program's languages, each under its own name. The first entry, `other`, stands for no
/// language. `chosen`: the id of a `LanguageInfo`, or empty.
QComboBox* createLanguageChoice(const QString& other, const QString& chosen);

}  // namespace alidade::ui
