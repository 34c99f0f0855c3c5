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

/// Makes the non-destructive button the default: it has the keyboard focus, and Return presses it wherever
/// the focus is. Call once all buttons of the dialog exist.
void makeSafeButton(QPushButton& button);

/// A wrapping label that shows its text without interpreting markup.
QLabel* createPlainLabel(const QString& text);

/// A list of the program's languages, each under its own name, below `other` for none of them; `chosen` is an
/// id of a `LanguageInfo` or empty.
QComboBox* createLanguageChoice(const QString& other, const QString& chosen);

}  // namespace alidade::ui
